// iViewMatrix as #iFirstPersonControls of the extension moves it: one step a frame.

const flySteps = [
  // key, axis (0 to 2 along x y z, 3 to 5 about them), direction
  [68, 0, 1], // D
  [65, 0, -1], // A
  [70, 1, 1], // F
  [82, 1, -1], // R
  [87, 2, 1], // W
  [83, 2, -1], // S
  [40, 3, 1],
  [38, 3, -1],
  [39, 4, 1],
  [37, 4, -1],
  [69, 5, 1], // E
  [81, 5, -1], // Q
];
const alt = 18;
const flySeconds = 0.1; // what the extension takes every frame for
const flyTurning = Math.PI / 24;

class FlyCamera {
  constructor() {
    this.position = [0, 0, 0];
    this.rotation = [0, 0, 0, 1]; // a quaternion
    this.steering = new Set(); // keys; one that is pressed while Alt is held does not count
  }

  // keys: rows of the keyboard. look: where a held mouse is, from the centre to the edges at 1; it takes the place of the
  // left and the down arrow.
  step(keys, look) {
    const looks = look[0] !== 0 || look[1] !== 0;
    const move = [0, 0, 0, 0, 0, 0];
    for (const [key, axis, direction] of flySteps) {
      if (!keys[key]) this.steering.delete(key);
      else if (!keys[alt]) this.steering.add(key);
      if (this.steering.has(key) && !(looks && (key === 37 || key === 40))) move[axis] += direction;
    }
    const axes = this.axes();
    for (let i = 0; i < 3; ++i)
      this.position[i] += flySeconds * (move[0] * axes[0][i] + move[1] * axes[1][i] + move[2] * axes[2][i]);
    const turn = [move[3] - look[1], move[4] + look[0], move[5]].map((amount) => flySeconds * flyTurning * amount);
    const length = Math.hypot(...turn, 1);
    const [x, y, z, w] = [...turn, 1].map((value) => value / length);
    const [a, b, c, d] = this.rotation;
    this.rotation = [
      a * w + d * x + b * z - c * y,
      b * w + d * y + c * x - a * z,
      c * w + d * z + a * y - b * x,
      d * w - a * x - b * y - c * z,
    ];
  }

  // The camera's own x, y and z in the world.
  axes() {
    const [x, y, z, w] = this.rotation;
    return [
      [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
      [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
      [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)],
    ];
  }

  matrix() {
    const [x, y, z] = this.axes();
    return [...x, 0, ...y, 0, ...z, 0, ...this.position, 1];
  }
}

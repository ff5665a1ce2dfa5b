// iMouse and the keyboard texture, from what hands do.

class Hands {
  constructor(canvas, project) {
    this.canvas = canvas;
    this.site = project.site;
    this.quirks = project.quirks;
    this.flies = project.flies;
    this.usesKeys = this.flies || project.passes.some((pass) => pass.keyboard || pass.inputs.some((i) => i.kind === 'keyboard'));
    this.keys = new Uint8Array(4 * 256); // rows: held, pressed, toggled, released
    this.forget();
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const name of ['pointerup', 'pointercancel']) addEventListener(name, (event) => this.release(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    addEventListener('keydown', (event) => this.keyDown(event));
    addEventListener('keyup', (event) => this.keyUp(event.keyCode));
    addEventListener('blur', () => this.letGo());
  }

  forget() {
    this.position = this.quirks ? [-1, -1] : [0, 0];
    this.pressedAt = this.quirks ? [1, 1] : [0, 0];
    this.down = this.pressed = this.released = false;
    this.look = [0, 0];
    this.camera = new FlyCamera();
    this.buttons = 0;
    this.keys.fill(0);
  }

  // Whole pixels from the lower left; the top row is the height, as the page measures y from the top. The extension
  // has neither whole pixels nor limits.
  place({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    const { width, height } = this.canvas;
    const place = [((clientX - box.left) / box.width) * width, height - ((clientY - box.top) / box.height) * height];
    if (this.quirks) return place;
    const [x, y] = place.map(Math.floor);
    return [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 1), height)];
  }

  press(event) {
    if (!event.isPrimary) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.position = this.pressedAt = this.place(event);
    this.down = this.pressed = true;
    this.released = false;
    this.look = [0, 0];
    this.buttons = event.buttons;
  }

  move(event) {
    if (!this.down || !event.isPrimary) return;
    this.buttons = event.buttons; // a second button is told as a move
    this.position = this.place(event);
    const box = this.canvas.getBoundingClientRect();
    this.look = [(2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height];
  }

  release(event) {
    if (event.isPrimary) this.letGoOfMouse();
  }

  letGoOfMouse() {
    this.released = this.down && !this.pressed;
    this.down = false;
    if (this.quirks) this.pressed = false;
    this.look = [0, 0];
    this.buttons = 0;
  }

  keyDown(event) {
    const code = event.keyCode;
    // Systems keep the ends of keys to themselves while their own key is held. Alt and arrows are the page's.
    if (event.metaKey || code > 255 || (event.altKey && (code === 38 || code === 40))) return;
    // A page must not scroll, nor lose the focus, under a shader that is played by keys.
    const plain = !event.altKey && !event.ctrlKey;
    if (plain && this.usesKeys && [8, 9, 32, 33, 34, 35, 36, 37, 38, 39, 40].includes(code)) event.preventDefault();
    if (event.repeat || this.keys[code]) return;
    this.keys[code] = this.keys[256 + code] = 255;
    this.keys[512 + code] ^= 255;
  }

  keyUp(code) {
    if (code > 255 || !this.keys[code]) return;
    this.keys[code] = 0;
    // On shadertoy.com a tap between two frames shows only in the toggle row.
    if (this.site) this.keys[256 + code] = 0;
    this.keys[768 + code] = 255;
  }

  letGo() {
    this.letGoOfMouse();
    for (let code = 0; code < 256; ++code) this.keyUp(code);
  }

  // Before every frame but those that are only drawn again.
  fly() {
    if (this.flies) this.camera.step(this.keys, this.look);
  }

  // What the next frame sees. z is positive while the mouse is down, w only in the first frame of a press, and in the
  // extension in the first one after it.
  frame() {
    const [x, y] = this.pressedAt;
    const mouse = [...this.position, this.down ? x : -x, this.pressed || (this.quirks && this.released) ? y : -y];
    return { mouse, buttons: [this.buttons & 1, (this.buttons >> 1) & 1, 0, 0], keys: this.keys, view: this.camera.matrix() };
  }

  endFrame() {
    this.pressed = this.released = false;
    this.keys.fill(0, 256, 512);
    this.keys.fill(0, 768);
  }
}

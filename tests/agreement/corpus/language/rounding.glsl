// green
void mainImage(out vec4 color, in vec2 p) {
  float z = 0.0 * p.x;
  bool ok = floor(-1.5 + z) == -2.0 && ceil(-1.5 + z) == -1.0 && trunc(-1.5 + z) == -1.0 && roundEven(2.5 + z) == 2.0 && roundEven(-3.5 + z) == -4.0;
  ok = ok && fract(-0.25 + z) == 0.75 && mod(-1.0 + z, 4.0) == 3.0 && mod(5.5 + z, -2.0) == -0.5 && sign(-0.5 + z) == -1.0 && abs(-2.0 + z) == 2.0;
  float whole;
  ok = ok && modf(-3.75 + z, whole) == -0.75 && whole == -3.0 && step(1.0, 1.0 + z) == 1.0 && clamp(5.0 + z, 0.0, 1.0) == 1.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

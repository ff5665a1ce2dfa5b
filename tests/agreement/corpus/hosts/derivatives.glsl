// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = dFdx(p.x) == 1.0 && dFdy(p.y) == 1.0 && dFdx(p.y) == 0.0 && fwidth(p.x * 2.0 + p.y) == 3.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

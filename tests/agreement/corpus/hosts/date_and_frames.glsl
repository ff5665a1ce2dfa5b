// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = iDate.x == 2024.0 && iDate.y == 0.0 && iDate.z == 1.0 && iDate.w >= 0.0 && iDate.w < 1.0 && iFrameRate == 60.0;
  ok = ok && abs(iTimeDelta - 1.0 / 60.0) < 1e-6 && iTime >= 2.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

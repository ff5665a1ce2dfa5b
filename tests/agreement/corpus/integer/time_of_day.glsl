void mainImage(out vec4 color, in vec2 p) {
  int seconds = int(p.y) * 1201 + int(p.x) * 7;
  int h = seconds / 3600 % 24, m = seconds / 60 % 60, s = seconds % 60;
  color = vec4(float(h) / 23.0, float(m) / 59.0, float(s) / 59.0, 1.0);
}

int spread(int v) {
  v = (v | (v << 4)) & 0x0F0F;
  v = (v | (v << 2)) & 0x3333;
  return (v | (v << 1)) & 0x5555;
}
void mainImage(out vec4 color, in vec2 p) {
  int m = spread(int(p.x) & 127) | (spread(int(p.y) & 127) << 1);
  color = vec4(float(m & 63) / 63.0, float((m >> 6) & 63) / 63.0, float(m >> 12) / 3.0, 1.0);
}

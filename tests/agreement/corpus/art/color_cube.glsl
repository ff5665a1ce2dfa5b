void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p) / 4;
  int i = q.x + q.y * 32;
  color = vec4(float(i & 7) / 7.0, float((i >> 3) & 7) / 7.0, float((i >> 6) & 3) / 3.0, 1.0);
}

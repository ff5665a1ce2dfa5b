uvec2 pcg(uvec2 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  return v ^ (v >> 16u);
}
void mainImage(out vec4 color, in vec2 p) {
  uvec2 h = pcg(uvec2(p) / 2u);
  color = vec4(vec2(h >> 24) / 255.0, float((h.x ^ h.y) & 255u) / 255.0, 1.0);
}

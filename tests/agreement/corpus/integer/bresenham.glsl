// Walks a line and remembers whether it came by.
bool on_line(ivec2 at, ivec2 a, ivec2 b) {
  ivec2 d = abs(b - a), s = ivec2(a.x < b.x ? 1 : -1, a.y < b.y ? 1 : -1);
  int e = d.x - d.y;
  for (int i = 0; i < 200; ++i) {
    if (a == at) return true;
    if (a == b) break;
    int e2 = 2 * e;
    if (e2 > -d.y) { e -= d.y; a.x += s.x; }
    if (e2 < d.x) { e += d.x; a.y += s.y; }
  }
  return false;
}
void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p) / 2;
  color = vec4(on_line(q, ivec2(3, 3), ivec2(58, 20)), on_line(q, ivec2(50, 33), ivec2(40, 2)), on_line(q, ivec2(5, 30), ivec2(30, 10)), 1.0);
}

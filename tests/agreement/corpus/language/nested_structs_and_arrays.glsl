// green
struct In { int k[2]; vec2 v; };
struct Out { In list[2]; float tail; };
Out make(int n) { Out o; for (int i = 0; i < 2; ++i) { o.list[i].k = int[2](n, n + i); o.list[i].v = vec2(n, i); } o.tail = float(n); return o; }
void mainImage(out vec4 color, in vec2 p) {
  Out a = make(3), b = a;
  bool same = a == b;
  b.list[1].k[1] += 1;
  int i = int(p.x) * 0 + 1;
  bool ok = same && a != b && b.list[i].k[i] == 5 && a.list[i].v == vec2(3.0, 1.0) && make(7).list[0].k[1] == 7;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// green
int sum(int list[4]) { int s = 0; for (int i = 0; i < list.length(); ++i) s += list[i]; return s; }
int[4] doubled(int list[4]) { for (int i = 0; i < 4; ++i) list[i] *= 2; return list; }
void fill(out float f[3], float v) { f[0] = v; f[1] = v + 1.0; f[2] = v + 2.0; }
void mainImage(out vec4 color, in vec2 p) {
  int a[] = int[](1, 2, 3, 4);
  int b[4] = doubled(a);
  float f[3];
  fill(f, 2.0);
  int i = 0;
  a[i++] += 10;
  a[++i] -= 1;
  bool ok = sum(b) == 20 && f[2] == 4.0 && a[0] == 11 && a[2] == 2 && i == 2 && b != a && doubled(b)[3] == 16;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

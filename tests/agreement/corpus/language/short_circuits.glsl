// green
int calls = 0;
bool yes() { ++calls; return true; }
bool no() { calls += 10; return false; }
void mainImage(out vec4 color, in vec2 p) {
  bool a = no() && yes();
  bool b = yes() || no();
  bool c = yes() ^^ no();
  int d = b ? (calls += 100, 1) : (calls += 1000, 2);
  bool ok = !a && b && c && d == 1 && calls == 122;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

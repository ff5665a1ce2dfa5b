// Conditionals, logic that short-circuits, commas and assignments as values.
int calls = 0;
bool tick(bool b) { calls++; return b; }
float bump(inout float x) { x += 1.0; return x; }
void mainImage(out vec4 color, in vec2 p) {
  float x = p.x, y = p.y, z;
  bool a = tick(x > 3.0) && tick(y > 3.0), b = tick(x > 5.0) || tick(y > 5.0), c = tick(a) ^^ tick(b);
  float r = x > y ? bump(x) : bump(y);
  z = x > 4.0 ? y > 2.0 ? 1.0 : 2.0 : 3.0;
  float w = (x = y + 1.0) * 2.0;
  int i = 0; i += i = 3;
  float s = a ? bump(x) + bump(y) : b && c ? -1.0 : bump(x) * 0.5;
  vec2 v = vec2(1.0); v.yx = v *= 2.0;
  if (!(a || b) && c == false) s += 0.5;
  color = vec4(r + z * 8.0, w + float(calls) * 32.0, s + float(i), v.x + v.y + x - y);
}

// green
void split(float x, out float whole, out float part) { whole = floor(x); part = x - whole; }
void bump(inout vec3 v, int axis) { v[axis] += 1.0; }
float both(inout float x) { x += 1.0; return x; }
void mainImage(out vec4 color, in vec2 p) {
  float w, f;
  split(3.25 + 0.0 * p.x, w, f);
  vec3 v = vec3(0.0);
  for (int i = 0; i < 3; ++i) bump(v, i);
  bump(v, 1);
  float x = 1.0;
  float y = both(x) * 10.0;
  mat2 m = mat2(0.0);
  split(7.5, m[1].x, m[0].y);
  bool ok = w == 3.0 && f == 0.25 && v == vec3(1.0, 2.0, 1.0) && x == 2.0 && y == 20.0 && m == mat2(0.0, 0.5, 7.0, 0.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

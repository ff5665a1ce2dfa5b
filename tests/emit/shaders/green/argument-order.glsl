// Arguments are evaluated from left to right; what comes in through an l-value is read when the call begins.
float trail = 0.;
float step_(float digit) { trail = trail * 10. + digit; return digit; }
int slot(int i) { trail = trail * 10. + float(i); return i; }
void three(float a, inout float b, float c) { b = b * 100. + a * 10. + c; }
void swap(inout float a, inout float b) { float t = a; a = b; b = t; }
float doubled(inout float x) { x *= 2.; return x; }
void add(inout float to, float what) { to += what; }
void mainImage(out vec4 o, vec2 p) {
  float zero = iTime;
  bool ok = true;
  float list[3] = float[3](1., 2., 3.);
  three(step_(4.), list[slot(1)], step_(6.));
  ok = ok && trail == 416. && list[1] == 246.;
  float x = 3. + zero;
  add(x, doubled(x));
  ok = ok && x == 12.;
  x = 3.;
  three(doubled(x), x, doubled(x));
  ok = ok && x == 1200. + 60. + 12.;
  x = 1.;
  float y = 2.;
  swap(x, y);
  swap(list[0], list[2]);
  ok = ok && x == 2. && y == 1. && list[0] == 3. && list[2] == 1.;
  vec2 v = vec2(1., 2.);
  swap(v.x, v.y);
  ok = ok && v == vec2(2., 1.);
  if (p.x > 20.) { add(v.y, doubled(v.y)); ok = ok && v.y == 4.; }
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

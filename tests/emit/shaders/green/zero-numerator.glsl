// green = right. Zero over zero is NaN, and over another number a zero with its sign, also where a compiler
// knows the numerator before the shader runs.
struct Pair {
  float a;
  vec2 b;
};
float nothing() { return 0.0; }
float over(float a, float b) { return a / b; }
void clear(out float a) { a = 0.0; }
bool negative_zero(float x) { return x == 0.0 && floatBitsToUint(x) == 0x80000000u; }
void mainImage(out vec4 o, vec2 p) {
  float y = floor(p.x * 1e-6), two = y - 2.0, z = 0.0, w = p.x, cleared = p.y, less = 1.0, self = 0.0;
  w = 0.0;
  less -= 1.0;
  clear(cleared);
  Pair pair = Pair(0.0, vec2(p.x, 0.0));
  float list[3] = float[3](1.0, 0.0, 2.0), unset;
  vec3 whole = vec3(0.0) / vec3(y), part = vec3(1.0, p.x, 0.0), written = p.xyx;
  written.y = 0.0;
  written.x = 3.0;
  bool ok = isnan(0.0 / y) && isnan(z / y) && isnan(nothing() / y) && isnan(over(0.0, y)) && isnan(whole.x) && isnan(whole.z) &&
            isnan((part / y).z) && (part / y).x > 1.0 && isnan((vec2(0.0) / y).y) && isnan(w / y) && isnan(cleared / y) && isnan(unset / y) &&
            isnan(less / y) && isnan(pair.a / y) && isnan(pair.b.y / y) && isnan(list[1] / y) && isnan(written.y / y) &&
            isnan(float(0) / y) && isnan((p.x > 0.0 ? 0.0 : z) / y) && isnan(-0.0 / y) && isnan(0.0 / 0.0) && isnan(0.0 / (0.0 / y)) &&
            isnan((mat2(0.0) / y)[1][0]) && isnan((mat2x3(0.0) / mat2x3(y))[1][2]) && isinf((1.0 / mat2(0.0))[0].y);
  for (int i = 0; i < 3; ++i) {
    ok = ok && (i == 0 ? isnan(float(i) / y) : isinf(float(i) / y));
    ok = ok && (i == 0 ? isnan(self / y) : isinf(self / y));
    self += p.x;
  }
  ok = ok && negative_zero(0.0 / two) && negative_zero(z / two) && negative_zero((vec3(0.0) / two).y) && 0.0 / -two == 0.0 &&
       !negative_zero(0.0 / -two);
  z /= y;
  o = vec4(ok && isnan(z) ? 0. : 1., ok && isnan(z) ? 1. : 0., 0., 1.);
}

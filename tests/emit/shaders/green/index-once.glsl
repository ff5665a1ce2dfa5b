// An index with an effect is evaluated once, wherever its l-value stands.
int calls = 0;
int next() { return calls++; }
void both(inout float a, out float b) { a += 1.; b = a * 2.; }
float grow(float by, inout vec2 v) { v += by; return v.x; }
void mainImage(out vec4 o, vec2 p) {
  float zero = iTime;
  bool ok = true;
  int i = 0, j = 1;
  vec3 a[2] = vec3[2](vec3(1., 2., 3.), vec3(4., 5., 6.));
  a[i++][j++] += 10. + zero;
  a[i][i++] *= 2.;
  ok = ok && i == 2 && j == 2 && a[0][1] == 12. && a[1][1] == 10.;
  mat3 m = mat3(1., 2., 3., 4., 5., 6., 7., 8., 9.);
  i = 0; j = 2;
  m[i++][j--] /= 3. + zero;
  m[++i][--j]++;
  ok = ok && i == 2 && j == 0 && m[0][2] == 1. && m[2][0] == 8.;
  vec4 v = vec4(1., 2., 3., 4.);
  i = 0;
  v.wzyx[i++] -= 1. + zero;
  v.wzyx[i++]--;
  v.yz[next()] *= 5.;
  ok = ok && i == 2 && calls == 1 && v == vec4(1., 10., 2., 3.);
  ivec3 k = ivec3(7, 8, 9);
  i = 0;
  k.zx[i++] %= 4;
  k.zyx[i++] <<= 1;
  ok = ok && i == 2 && k == ivec3(7, 16, 1);
  both(a[next()][next()], a[0][next() - 3]);
  ok = ok && calls == 4 && a[1][2] == 7. && a[0][0] == 14.;
  i = 0;
  both(v.zw[i++], v.xy[i]);
  ok = ok && i == 1 && v == vec4(1., 6., 3., 3.);
  i = 0;
  float s = grow(float(++i), m[i].zx) + grow(float(++i), m[i].yz);
  ok = ok && i == 2 && s == 7. + 10. && m[1] == vec3(5., 5., 7.) && m[2] == vec3(8., 10., 11.);
  int list[3] = int[3](1, 2, 3);
  i = 0;
  list[i++] /= (list[0] = 4, 2);
  i = int(p.x) - int(p.x) + 1;
  list[i--] += i;
  ok = ok && i == 0 && list[0] == 2 && list[1] == 2;
  int lane = int(p.x) & 3;
  int before = lane;
  v = vec4(0.);
  v.wzyx[lane++] += 3.;
  ok = ok && lane == before + 1 && v[3 - before] == 3. && dot(v, vec4(1.)) == 3.;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

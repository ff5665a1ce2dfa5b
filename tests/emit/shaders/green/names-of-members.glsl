// green = right. Members are called as the structure, a global or a built-in function is.
float sin = 1., findMSB = 2.;
struct fma { float fma, sin; };
struct mix { float fract; fma mix[2]; };
struct length { highp float length, findMSB; };
void mainImage(out vec4 o, vec2 p) {
  struct abs { vec2 abs; } a = abs(vec2(3.));
  fma f = fma(4., 5.);
  mix m = mix(6., fma[2](f, fma(7., 8.)));
  m.mix[1].sin += sin;
  length l = length(9., 10.);
  l.length += findMSB;
  bool ok = sin == 1. && findMSB == 2. && a.abs.y == 3. && f.fma == 4. && f.sin == 5. && m.fract == 6.;
  ok = ok && m.mix[0].fma == 4. && m.mix[1] == fma(7., 9.) && l.length == 11. && l.findMSB == 10.;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

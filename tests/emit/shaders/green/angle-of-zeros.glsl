// green = right. atan(0.0, 0.0) is 0, whatever the signs.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6);
  vec2 v = atan(vec2(zero, 1.0 + zero), vec2(zero));
  bool ok = atan(zero, zero) == 0.0 && atan(-zero, zero) == 0.0 && atan(zero, -zero) == 0.0 && atan(-zero, -zero) == 0.0 &&
            atan(0.0, zero) == 0.0 && atan(zero, 0.0) == 0.0 && v.x == 0.0 && abs(v.y - 1.5707963) < 1e-5 &&
            abs(atan(zero, -1.0) - 3.1415927) < 1e-5 && atan(zero, 1.0) == 0.0 && abs(atan(zero + 1.0, zero) - 1.5707963) < 1e-5;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

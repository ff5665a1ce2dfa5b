// green = right. Division by zero is infinite, or NaN of zero, also by a constant.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), one = 1.0 + zero, y = -one;
  y /= 0.0;
  vec3 v = vec3(one, -one, one) / vec3(0.0, zero, 4.0);
  vec2 w = vec2(one, -2.0) / 0.0;
  bool ok = isinf(one / 0.0) && one / 0.0 > 0.0 && isinf(-one / 0.0) && -one / 0.0 < 0.0 && isnan(zero / 0.0) && isinf(one / zero) &&
            isnan(zero / zero) && isinf(y) && y < 0.0 && isinf(v.x) && isinf(v.y) && v.y < 0.0 && v.z == 0.25 && isinf(w.x) && w.y < 0.0 &&
            one * 2.0 / 0.0 > 1.0 && min(one / 0.0, 5.0) == 5.0 && one / (one / 0.0) == 0.0;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

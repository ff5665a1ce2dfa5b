// green = right. pow(x, 0.0) is 1; pow(0.0, y) is 0 for a positive and infinite for a negative y; of a negative x it is NaN.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), one = 1.0 + zero;
  bool ok = pow(zero, 0.0) == 1.0 && pow(zero, zero) == 1.0 && pow(0.0, zero) == 1.0 && pow(-one, zero) == 1.0 && pow(-one, 0.0) == 1.0 &&
            isinf(pow(zero, -1.0)) && pow(zero, -one) > 0.0 && isinf(pow(0.0, -one)) && pow(zero, one) == 0.0 && pow(zero, 0.5) == 0.0 &&
            pow(0.0, one) == 0.0 && isnan(pow(-one * 2.0, one * 0.5)) && pow(vec2(zero, one), vec2(zero)) == vec2(1.0) &&
            pow(vec3(zero), vec3(0.0, 1.0, 2.0)) == vec3(1.0, 0.0, 0.0);
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

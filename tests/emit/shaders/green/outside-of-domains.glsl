// green = right. Roots and logarithms outside of their domains, and the direction of nothing.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), one = 1.0 + zero;
  bool ok = isnan(sqrt(-one)) && isinf(inversesqrt(zero)) && inversesqrt(zero) > 0.0 && isnan(inversesqrt(-one)) && isinf(log(zero)) &&
            log(zero) < 0.0 && isnan(log(-one)) && isinf(log2(zero)) && isnan(log2(-one)) && isnan(asin(one * 1.5)) && isnan(acos(one * 1.5)) &&
            isnan(acosh(one * 0.5)) && isnan(atanh(one * 2.0)) && isnan(normalize(vec2(zero)).x) && isnan(normalize(vec3(zero)).z) &&
            isnan(normalize(vec4(zero)).w) && isnan(mod(one, one / zero));
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

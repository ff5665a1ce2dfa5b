// green = right. clamp() is min(max(x, low), high); of a NaN and a number, min, max and clamp take the number.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), one = 1.0 + zero, nan = zero / zero;
  int low = int(one) * 10;
  bool ok = clamp(0.5 + zero, 1.0, 0.0) == 0.0 && clamp(0.5 + zero, one, zero) == 0.0 && clamp(-one, one, zero) == 0.0 &&
            clamp(2.0 * one, one, zero) == 0.0 && clamp(5, low, 0) == 0 && clamp(20, low, int(zero)) == 0 &&
            clamp(vec2(0.5, 2.0) * one, vec2(one, 0.0), vec2(0.0, one)) == vec2(0.0, 1.0) && clamp(nan, 0.0, 1.0) == 0.0 &&
            clamp(nan, 2.0, 3.0) == 2.0 && clamp(nan, one, 2.0 * one) == 1.0 && clamp(0.5 * one, nan, 1.0) == 0.5 &&
            max(nan, 0.0) == 0.0 && max(0.5 * one, nan) == 0.5 && min(nan, one) == 1.0 && min(-one, nan) == -1.0 &&
            max(vec2(nan, one), 0.0) == vec2(0.0, 1.0);
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

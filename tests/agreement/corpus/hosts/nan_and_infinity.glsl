// green
void mainImage(out vec4 color, in vec2 p) {
  float zero = 0.0 * p.x;
  float infinity = 1.0 / zero, nan = zero / zero;
  bool ok = isinf(infinity) && isinf(-infinity) && isnan(nan) && !isnan(infinity) && !isinf(zero) && nan != nan && infinity > 1e38;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// The remainder of multiples of 0.3 by 0.1. REPAIRED: in whole tenths.
// options:
void mainImage(out vec4 color, in vec2 position) {
  float i = floor(position.x);
#ifdef REPAIRED
  float rest = 0.1 * fract(3.0 * i);
#else
  float rest = mod(0.3 * i, 0.1);  // here: jump
#endif
  color = vec4(9.0 * rest);
}

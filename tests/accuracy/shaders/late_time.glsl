// The sine of a phase that has grown for a day. REPAIRED: whole turns are left out first.
// options: --time 86400.3
void mainImage(out vec4 color, in vec2 position) {
#ifdef REPAIRED
  float wave = sin(314.159265 * fract(iTime));
#else
  float wave = sin(314.159265 * iTime);  // here: conditioning
#endif
  color = vec4(0.5 + 0.5 * wave);
}

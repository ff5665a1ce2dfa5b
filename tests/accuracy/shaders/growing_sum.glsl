// A sum over frames, which is too large for what is added. REPAIRED: what has been added is kept apart.
// options: --frames 200
#iChannel0 "self"
#iChannel0::MinFilter "Nearest"
#iChannel0::MagFilter "Nearest"
void mainImage(out vec4 color, in vec2 position) {
  float sum = texelFetch(iChannel0, ivec2(position), 0).a;
#ifdef REPAIRED
  sum += 0.25;
  color = vec4(vec3(0.02 * sum), sum);
#else
  if (iFrame == 0) sum = 4194304.0;
  sum += 0.25;  // here: absorption
  color = vec4(vec3(0.02 * (sum - 4194304.0)), sum);
#endif
}

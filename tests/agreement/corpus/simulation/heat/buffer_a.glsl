vec4 T(ivec2 d, vec2 p) { return texelFetch(iChannel0, clamp(ivec2(p) + d, ivec2(0), ivec2(iResolution.xy) - 1), 0); }
void mainImage(out vec4 color, in vec2 p) {
  if (iFrame == 0) { color = vec4(length(p - 0.5 * iResolution.xy) < 15.0 ? 1.0 : 0.0); return; }
  vec4 m = T(ivec2(0), p);
  color = m + 0.2 * (T(ivec2(1, 0), p) + T(ivec2(-1, 0), p) + T(ivec2(0, 1), p) + T(ivec2(0, -1), p) - 4.0 * m);
}

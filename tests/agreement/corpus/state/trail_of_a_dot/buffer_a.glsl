void mainImage(out vec4 color, in vec2 p) {
  float old = texelFetch(iChannel0, ivec2(p), 0).r * 0.875;
  vec2 at = vec2(8.0 + 12.0 * float(iFrame), 30.5);
  vec2 d = abs(p - at);
  color = vec4(max(d.x, d.y) < 6.0 ? 1.0 : old);
}

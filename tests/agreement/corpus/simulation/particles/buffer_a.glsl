// One particle a texel of the lowest row: place in xy, velocity in zw.
void mainImage(out vec4 color, in vec2 p) {
  if (p.y > 1.0 || p.x > 16.0) { color = vec4(0.0); return; }
  vec4 q = texelFetch(iChannel0, ivec2(p), 0);
  if (iFrame == 0) q = vec4(0.0625 * p.x, 0.5, 0.01 * (p.x - 8.0), 0.02);
  q.zw -= 0.0625 * (q.xy - 0.5);
  q.xy += q.zw;
  color = q;
}

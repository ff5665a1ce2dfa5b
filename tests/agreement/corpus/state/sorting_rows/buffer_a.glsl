// Odd and even transposition: every frame compares neighbours.
float first(ivec2 p) { return fract(float((p.x * 97 + p.y * 57) % 61) / 61.0); }
void mainImage(out vec4 color, in vec2 position) {
  ivec2 p = ivec2(position);
  if (iFrame == 0) { color = vec4(first(p)); return; }
  int side = (p.x + iFrame) % 2 == 0 ? 1 : -1;
  ivec2 q = p + ivec2(side, 0);
  float own = texelFetch(iChannel0, p, 0).r;
  if (q.x < 0 || q.x >= int(iResolution.x)) { color = vec4(own); return; }
  float other = texelFetch(iChannel0, q, 0).r;
  color = vec4(side > 0 ? min(own, other) : max(own, other));
}

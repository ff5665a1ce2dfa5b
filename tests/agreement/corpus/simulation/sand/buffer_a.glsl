// Grains fall into empty cells: pairs of rows take turns, so that none is lost.
float at(ivec2 q) { return q.y < 0 ? 1.0 : texelFetch(iChannel0, q, 0).r; }
void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  if (iFrame == 0) { color = vec4((q.x * 5 + q.y * 3) % 7 < 2 ? 1.0 : 0.0); return; }
  bool upper = ((q.y + iFrame) & 1) == 1;
  float own = at(q), other = upper ? at(q - ivec2(0, 1)) : at(q + ivec2(0, 1));
  if (!upper && q.y + 1 >= int(iResolution.y)) other = 0.0;
  color = vec4(upper ? (other == 0.0 ? 0.0 : own) : max(own, other));
}

void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  color = texelFetch(iChannel0, q, 0);
  if (q == TICKS) color.x += 1.0;
  if (q == SEED) color.x = float(hash(uint(iFrame) + 7u) & 0xffffu);
}

void mainImage(out vec4 color, in vec2 p) {
  uint seed = uint(texelFetch(iChannel0, SEED, 0).x);
  float ticks = texelFetch(iChannel0, TICKS, 0).x;
  vec2 c = cell_of(p);
  uint h = hash(seed + uint(c.x) * 131u + uint(c.y));
  color = vec4(float(h & 255u) / 255.0, ticks / 4.0, step(0.5, p.x / RES.x), 1.0);
}

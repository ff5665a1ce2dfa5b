int at(ivec2 p) {
  ivec2 size = ivec2(iResolution.xy);
  return int(texelFetch(iChannel0, (p + size) % size, 0).r + 0.5);
}
void mainImage(out vec4 color, in vec2 position) {
  ivec2 p = ivec2(position);
  if (iFrame == 0) {
    color = vec4(((p.x * 7 + p.y * 13 + (p.x * p.y) % 5) % 3) == 0);
    return;
  }
  int n = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (x != 0 || y != 0) n += at(p + ivec2(x, y));
  color = vec4(n == 3 || (n == 2 && at(p) == 1));
}

void mainImage(out vec4 color, in vec2 p) {
  color = vec4(0.0, 0.0, 0.05, 1.0);
  for (int layer = 1; layer <= 3; ++layer) {
    vec2 q = p / (6.0 * float(layer)) + vec2(iTime * 4.0 / float(layer), 0.0);
    ivec2 c = ivec2(floor(q));
    int h = (c.x * 1619 + c.y * 31337 + layer * 6971) & 0xff;
    if (h < 12) color.rgb += float(h) / 24.0 * step(length(fract(q) - 0.5), 0.25);
  }
}

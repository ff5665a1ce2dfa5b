vec2 at(vec2 p, float x, float y) { return textureLod(iChannel0, (p + vec2(x, y)) / iResolution.xy, 0.0).xy; }
void mainImage(out vec4 color, in vec2 p) {
  if (iFrame == 0) {
    vec2 g = mod(p, 24.0) - 12.0;
    color = vec4(1.0, dot(g, g) < 20.0 ? 1.0 : 0.0, 0.0, 1.0);
    return;
  }
  vec2 c = at(p, 0.0, 0.0);
  vec2 l = 0.2 * (at(p, 1.0, 0.0) + at(p, -1.0, 0.0) + at(p, 0.0, 1.0) + at(p, 0.0, -1.0)) +
           0.05 * (at(p, 1.0, 1.0) + at(p, -1.0, 1.0) + at(p, 1.0, -1.0) + at(p, -1.0, -1.0)) - c;
  float r = c.x * c.y * c.y;
  color = vec4(c + vec2(l.x - r + 0.037 * (1.0 - c.x), 0.5 * l.y + r - 0.097 * c.y), 0.0, 1.0);
}

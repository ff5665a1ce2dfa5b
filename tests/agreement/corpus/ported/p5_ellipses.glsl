vec3 canvas = vec3(0.12);
void fill_ellipse(vec2 at, float x, float y, float w, float h, vec3 c) { vec2 d = (at - vec2(x, y)) / (0.5 * vec2(w, h)); if (dot(d, d) <= 1.0) canvas = c; }
void fill_rect(vec2 at, float x, float y, float w, float h, vec3 c) { if (at.x >= x && at.x < x + w && at.y >= y && at.y < y + h) canvas = c; }
void mainImage(out vec4 color, in vec2 p) {
  vec2 at = vec2(p.x, iResolution.y - p.y);
  for (int i = 0; i < 6; i++) {
    fill_rect(at, 8.0 + 20.0 * float(i), 10.0, 12.0, 8.0 * float(i + 1), vec3(0.8, 0.2 * float(i), 0.3));
    fill_ellipse(at, 14.0 + 20.0 * float(i), 60.0, 16.0, 10.0 - float(i), vec3(0.2, 0.7, 0.15 * float(i)));
  }
  color = vec4(canvas, 1.0);
}

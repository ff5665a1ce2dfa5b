float n(vec2 p) { vec2 i = floor(p), f = p - i; f *= f * (3.0 - 2.0 * f); vec4 v = fract((vec4(0, 1, 57, 58) + i.x + 57.0 * i.y) * 0.1031); v = fract(v * (v + 33.33)); return mix(mix(v.x, v.y, f.x), mix(v.z, v.w, f.x), f.y); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / 24.0;
  vec2 w = vec2(n(q), n(q + 5.2));
  color = vec4(n(q + 2.0 * w), w, 1.0);
}

float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + 1.0), f.x), f.y);
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / 20.0;
  float v = 0.0, a = 0.5;
  for (int i = 0; i < 5; ++i) { v += a * noise(q); q = q * 2.02 + 7.1; a *= 0.5; }
  color = vec4(vec3(v), 1.0);
}

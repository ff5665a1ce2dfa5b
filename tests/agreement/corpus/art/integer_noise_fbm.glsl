uint mix_bits(uint x) { x = (x ^ 61u) ^ (x >> 16); x *= 9u; x ^= x >> 4; x *= 0x27d4eb2du; return x ^ (x >> 15); }
float lattice(ivec2 c) { return float(mix_bits(uint(c.x) + 57u * uint(c.y)) & 0xffffu) / 65535.0; }
float noise(vec2 p) {
  ivec2 i = ivec2(floor(p));
  vec2 f = p - floor(p);
  float a = lattice(i), b = lattice(i + ivec2(1, 0)), c = lattice(i + ivec2(0, 1)), d = lattice(i + ivec2(1, 1));
  return a + (b - a) * f.x + (c - a) * f.y + (a - b - c + d) * f.x * f.y;
}
void mainImage(out vec4 color, in vec2 p) {
  float v = 0.0, s = 1.0;
  for (int o = 0; o < 4; o++, s *= 2.0) v += noise(p / 32.0 * s) / (2.0 * s);
  color = vec4(v, v * v, 1.0 - v, 1.0);
}

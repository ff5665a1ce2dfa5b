// A table of gradients, written out by a script.
const vec2 g[16] = vec2[16](vec2(1.0, 0.0), vec2(0.92, 0.38), vec2(0.71, 0.71), vec2(0.38, 0.92), vec2(0.0, 1.0),
                            vec2(-0.38, 0.92), vec2(-0.71, 0.71), vec2(-0.92, 0.38), vec2(-1.0, 0.0), vec2(-0.92, -0.38),
                            vec2(-0.71, -0.71), vec2(-0.38, -0.92), vec2(0.0, -1.0), vec2(0.38, -0.92),
                            vec2(0.71, -0.71), vec2(0.92, -0.38));
int h(ivec2 c) { return ((c.x * 73 + c.y * 149) ^ (c.x * 31 >> 2)) & 15; }
float n(vec2 p) {
  vec2 f = fract(p);
  ivec2 c = ivec2(floor(p));
  vec2 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float a = dot(g[h(c)], f), b = dot(g[h(c + ivec2(1, 0))], f - vec2(1.0, 0.0));
  float d = dot(g[h(c + ivec2(0, 1))], f - vec2(0.0, 1.0)), e = dot(g[h(c + 1)], f - 1.0);
  return a + (b - a) * u.x + (d - a) * u.y + (a - b - d + e) * u.x * u.y;
}
void mainImage(out vec4 color, in vec2 p) { color = vec4(0.5 + 0.5 * vec3(n(p / 16.0), n(p / 9.0), n(p / 5.0)), 1.0); }

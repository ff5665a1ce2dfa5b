#define PI 3.14159265
#define ROT(a) mat2(cos(a), -sin(a), sin(a), cos(a))
#define REP(p, c) (mod(p + 0.5 * (c), c) - 0.5 * (c))
#define MERGE(a, b) a = min(a, b)
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = (2.0 * p - iResolution.xy) / iResolution.y;
  float d = 1e9;
  vec2 q = REP(uv * ROT(PI / 5.0), 0.5);
  MERGE(d, length(q) - 0.12);
  MERGE(d, abs(uv.y + 0.3 * uv.x) - 0.04);
  color = vec4(vec3(smoothstep(0.0, 0.03, d)) * vec3(0.9, 0.7, 0.5), 1.0);
}

float op_0(vec2 p) { return length(p - vec2(-0.3, 0.1)) - 0.4; }
float op_1(vec2 p) { vec2 q = abs(p - vec2(0.2, -0.1)) - vec2(0.35, 0.25); return max(q.x, q.y); }
float op_2(vec2 p) { return dot(p, vec2(0.6, 0.8)) - 0.15; }
float op_3(vec2 p) { return min(op_0(p), op_1(p)); }
float op_4(vec2 p) { return max(op_3(p), op_2(p)); }
float op_5(vec2 p) { return max(op_4(p), -(length(p) - 0.15)); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float d = op_5(q);
  color = vec4(d < 0.0 ? vec3(0.9, 0.5, 0.2) : vec3(0.2, 0.25, 0.3) * (1.0 + 0.5 * step(0.5, fract(d * 8.0))), 1.0);
}

vec4 qmul(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz)); }
vec4 qconj(vec4 q) { return vec4(-q.xyz, q.w); }
vec3 qrot(vec4 q, vec3 v) { return qmul(qmul(q, vec4(v, 0.0)), qconj(q)).xyz; }
void mainImage(out vec4 color, vec2 p) {
  vec2 uv = (2.0 * p - iResolution.xy) / iResolution.y;
  vec4 q = vec4(0.36, 0.48, 0.0, 0.8);
  vec3 d = qrot(q, vec3(uv, 1.5));
  vec3 a = abs(d);
  float m = max(a.x, max(a.y, a.z));
  vec3 face = step(vec3(m), a);
  vec3 cell = step(0.5, fract(d / m * 2.0 + 0.001));
  color = vec4(0.2 + 0.6 * face * (0.5 + 0.5 * cell.yzx), 1.0);
}

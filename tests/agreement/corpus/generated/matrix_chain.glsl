const mat4 m_0 = mat4(0.8, 0.6, 0.0, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
const mat4 m_1 = mat4(1.0, 0.0, 0.0, 0.0, 0.0, 0.28, 0.96, 0.0, 0.0, -0.96, 0.28, 0.0, 0.0, 0.0, 0.0, 1.0);
const mat4 m_2 = mat4(2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.25, -0.5, 0.125, 1.0);
void mainImage(out vec4 color, in vec2 p) {
  vec4 v = m_2 * (m_1 * (m_0 * vec4(p / iResolution.xy - 0.5, 0.2, 1.0)));
  vec4 w = (m_2 * m_1 * m_0) * vec4(p / iResolution.xy - 0.5, 0.2, 1.0);
  color = vec4(0.5 + 0.25 * v.xyz, 1.0) + vec4(vec3(distance(v, w) > 1e-4), 0.0);
}

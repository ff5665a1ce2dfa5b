#define DECLARE_LERP(T) T blend(T a, T b, float t) { return a * (1.0 - t) + b * t; }
DECLARE_LERP(float)
DECLARE_LERP(vec2)
DECLARE_LERP(vec3)
#undef DECLARE_LERP
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec2 q = blend(uv, uv.yx, 0.25);
  color = vec4(blend(vec3(q, 0.2), vec3(1.0, q), blend(0.0, 1.0, uv.x)), 1.0);
}

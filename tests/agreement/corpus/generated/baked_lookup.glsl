// A curve that was sampled offline.
const float curve[17] = float[17](0.0, 0.02, 0.07, 0.15, 0.26, 0.38, 0.52, 0.64, 0.75, 0.84, 0.9, 0.94, 0.97, 0.985, 0.993, 0.998, 1.0);
float evaluate(float x) {
  float at = clamp(x, 0.0, 1.0) * 16.0;
  int i = min(int(at), 15);
  float t = at - float(i);
  return curve[i] + (curve[i + 1] - curve[i]) * t;
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  float y = evaluate(uv.x);
  color = vec4(step(uv.y, y), y, evaluate(1.0 - uv.x), 1.0);
}

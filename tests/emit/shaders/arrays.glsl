// Constant arrays, clamped indices, length(), arrays by value, initialiser forms.
const vec3 palette[4] = vec3[](vec3(0.1, 0.2, 0.3), vec3(1.0), vec3(0.5, 0.25, 0.125), vec3(-1.0, 2.0, 7.0));
const int steps[5] = int[5](3, 1, 4, 1, 5);
const mat2 turns[2] = mat2[](mat2(0.0, 1.0, -1.0, 0.0), mat2(0.5));
float table[6];
float total(float v[6]) { v[0] = 100.0; float s = 0.0; for (int i = 0; i < v.length(); i++) s += v[i]; return s; }
float[2] both(float a) { return float[](a, a * a); }
void mainImage(out vec4 color, in vec2 p) {
  int k = int(p.x) % 8;
  for (int i = 0; i < 6; ++i) table[i] = float(i * i);
  const float weights[] = float[](0.25, 0.5, 0.125);
  float w = 0.0;
  for (int i = 0; i < weights.length(); i++) w += weights[i] * float(i + 1);
  float local[3];
  local[k % 3] = 2.0;
  float copy[3] = local;
  copy[0] += 1.0;
  vec2 turned = turns[k & 1] * vec2(1.0, 2.0);
  color = vec4(palette[clamp(k, 0, 3)][k % 3], float(steps[k % 5]) + total(table) * 16.0, w + both(p.y)[1], turned.x);
  if (p.y > 3.0) color = vec4(local[0] + local[1], copy[0], copy == local ? 1.0 : 0.0, table[5]);
}

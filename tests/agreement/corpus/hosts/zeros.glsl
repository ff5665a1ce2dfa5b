// green
float unset;
void nothing(out vec3 v) { }
float early(float x) { if (x > 1e6) return 1.0; }
void mainImage(out vec4 color, in vec2 p) {
  float local;
  ivec2 pair;
  vec3 v = vec3(9.0);
  nothing(v);
  bool ok = unset == 0.0 && local == 0.0 && pair == ivec2(0) && v == vec3(0.0) && early(p.x) == 0.0 && color == vec4(0.0);
  for (int i = 0; i < 2; ++i) { float each; ok = ok && each == 0.0; each = 5.0; }
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// GLSL 1.20 habits: every array unrolled, every index a branch.
float weight(int i) {
  if (i == 0) return 0.0625;
  else if (i == 1) return 0.25;
  else if (i == 2) return 0.375;
  else if (i == 3) return 0.25;
  return 0.0625;
}
float image(vec2 p) { return mod(floor(p.x / 9.0) + floor(p.y / 7.0), 2.0); }
void mainImage(out vec4 c, in vec2 p) {
  float sum = 0.0;
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 5; j++) sum += weight(i) * weight(j) * image(p + vec2(float(i - 2), float(j - 2)) * 2.0);
  c = vec4(vec3(sum), 1.0);
}

void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (p - 0.5 * iResolution.xy) / 9.0;
  int sum = 0;
  const vec2 ways[5] = vec2[5](vec2(1.0, 0.0), vec2(0.309017, 0.951057), vec2(-0.809017, 0.587785), vec2(-0.809017, -0.587785), vec2(0.309017, -0.951057));
  for (int i = 0; i < 5; ++i) sum += int(floor(dot(q, ways[i]) + 0.2));
  int m = ((sum % 5) + 5) % 5;
  color = vec4(float(m) / 4.0, float((m * 2) % 5) / 4.0, float((m * 3) % 5) / 4.0, 1.0);
}

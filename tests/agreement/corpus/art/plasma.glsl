void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / 10.0;
  float v = sin(q.x + iTime) + sin(0.5 * (q.y + iTime)) + sin(0.5 * (q.x + q.y + iTime)) + sin(length(q) + 1.0);
  color = vec4(0.5 + 0.5 * sin(3.14159 * v * vec3(0.5) + vec3(0.0, 2.1, 4.2)), 1.0);
}

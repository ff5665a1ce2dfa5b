void mainImage(out vec4 color, in vec2 p) {
  vec2 g = abs(fract(p / vec2(32.0, 24.0)) - 0.5);
  color = vec4(g.x + g.y < 0.15 ? vec3(4.0, 3.0, 1.0) : vec3(0.05), 1.0);
}

void mainImage(out vec4 color, in vec2 p) {
  float x = p.x / iResolution.x * 4.0 - 1.5;
  color = vec4(x, x * x - 0.5, p.y > 36.0 ? 1.0 / 0.0 : -1.0, 2.0);
}

void mainImage(out vec4 color, in vec2 p) {
  float f = abs(fract(p.x / 16.0) - 0.5) + abs(fract(p.y / 16.0) - 0.5) - 0.4;
  color = vec4(vec3(clamp(f / fwidth(f) + 0.5, 0.0, 1.0)), 1.0);
}

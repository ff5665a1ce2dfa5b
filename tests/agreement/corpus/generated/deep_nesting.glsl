float f(float x) { return x * 0.5 + 0.25; }
void mainImage(out vec4 color, in vec2 p) {
  float x = floor(p.x / 8.0) / 16.0;
  float y = f(f(f(f(f(f(f(f(x * (1.0 + (x * (2.0 + (x * (3.0 + (x * 4.0))))))))))))));
  float z = ((((((((x + 0.1) * 2.0) - 0.3) * 1.5) + 0.2) * 0.5) - x) * 1.25);
  color = vec4(y, z, (x > 0.5 ? (x > 0.75 ? (x > 0.9 ? 1.0 : 0.8) : 0.6) : (x > 0.25 ? 0.4 : 0.2)), 1.0);
}

float encode(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }
float decode(float x) { return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4); }
void mainImage(out vec4 color, in vec2 p) {
  float x = floor(p.x / 4.0) / (iResolution.x / 4.0);
  float row = p.y / iResolution.y;
  color = vec4(vec3(row < 0.33 ? x : row < 0.66 ? encode(x) : decode(x)), 1.0);
}

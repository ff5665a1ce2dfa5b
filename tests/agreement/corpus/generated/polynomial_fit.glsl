// Coefficients as a fitting program prints them.
vec3 palette(float t) {
  const vec3 c0 = vec3(0.0512731481481481, 0.1203703703703704, 0.2916666666666667);
  const vec3 c1 = vec3(1.4120370370370371, 0.2314814814814815, 1.7037037037037037);
  const vec3 c2 = vec3(-0.7870370370370370, 1.8518518518518519, -3.1481481481481481);
  const vec3 c3 = vec3(0.3240740740740741, -1.2037037037037037, 1.2962962962962963);
  return c0 + t * (c1 + t * (c2 + t * c3));
}
void mainImage(out vec4 color, in vec2 p) { color = vec4(palette(floor(p.x / iResolution.x * 32.0) / 32.0), 1.0); }

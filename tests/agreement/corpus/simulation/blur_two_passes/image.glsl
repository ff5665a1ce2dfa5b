void mainImage(out vec4 color, in vec2 p) {
  color = vec4(0.0);
  for (int i = -4; i <= 4; ++i) color += texture(iChannel0, (p + vec2(0.0, float(i))) / iResolution.xy) * (5.0 - abs(float(i)));
  color /= 25.0;
}

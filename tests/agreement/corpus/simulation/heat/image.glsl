void mainImage(out vec4 color, in vec2 p) {
  float v = texture(iChannel0, p / iResolution.xy).r;
  color = vec4(v, v * v, v * v * v, 1.0);
}

void mainImage(out vec4 color, in vec2 p) {
  float level = floor(p.x / iResolution.x * 7.0);
  color = textureLod(iChannel0, vec2(0.5, p.y / iResolution.y), level);
}

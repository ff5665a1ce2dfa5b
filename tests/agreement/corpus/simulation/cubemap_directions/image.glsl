void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  color = texture(iChannel0, vec3(q, 0.8));
}

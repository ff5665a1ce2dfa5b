void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  float a = texelFetch(iChannel0, q, 0).x;
  float b = texelFetch(iChannel0, q + ivec2(1, 0), 0).x;
  color = vec4(0.5 + 0.5 * a, 0.5 + 4.0 * (a - b), 0.5 - 0.5 * a, 1.0);
}

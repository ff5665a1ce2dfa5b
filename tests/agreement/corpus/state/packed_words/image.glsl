void mainImage(out vec4 color, in vec2 p) {
  uint n = floatBitsToUint(texelFetch(iChannel0, ivec2(p), 0).x) & 0x7fffffu;
  color = vec4(vec3(n & 255u, (n >> 8) & 255u, n >> 16) / 255.0, 1.0);
}

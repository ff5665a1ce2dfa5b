// Integers kept in the bits of floats.
void mainImage(out vec4 color, in vec2 p) {
  uvec4 w = floatBitsToUint(texelFetch(iChannel0, ivec2(p), 0));
  uint n = iFrame == 0 ? uint(p.x) * 31u + uint(p.y) : w.x & 0x7fffffu;
  n = (n * 1103u + 12345u) & 0x7fffffu;
  color = uintBitsToFloat(uvec4(0x3f800000u | n, 0x40000000u | (n >> 3), 0x3f800000u, 0x3f800000u));
}

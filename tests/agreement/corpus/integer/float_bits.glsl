// green
void mainImage(out vec4 color, in vec2 p) {
  float one = 1.0 + 0.0 * p.x;
  bool ok = floatBitsToInt(one) == 0x3f800000 && floatBitsToUint(-2.5 * one) == 0xc0200000u;
  ok = ok && abs(intBitsToFloat(0x40490fdb + int(one) - 1) - 3.14159274) < 1e-6 && uintBitsToFloat(0x3f000000u) == 0.5;
  int e = (floatBitsToInt(1000.0 * one) >> 23) - 127;
  ok = ok && e == 9 && packHalf2x16(vec2(one, -2.0)) == 0xc0003c00u && unpackHalf2x16(0x3c00u) == vec2(1.0, 0.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

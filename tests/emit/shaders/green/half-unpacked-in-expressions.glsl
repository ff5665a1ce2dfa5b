// green = right. What unpackHalf2x16 gives is computed with in 32 bits, wherever it stands. is() compares in 32 bits.
vec2 unpacked(uint bits) { return unpackHalf2x16(bits); }
float scaled(float x) { return x * 6000.0; }
bool is(float x) { return x == 72000.0; }
void mainImage(out vec4 o, vec2 p) {
  uint h = packHalf2x16(vec2(12.0, p.x));
  vec2 kept = unpackHalf2x16(h);
  float y = 6000.0;
  y *= unpackHalf2x16(h).x;
  bool ok = is(scaled(unpackHalf2x16(h).x)) && is(scaled(unpacked(h).x)) && is(kept.x * 6000.0) && is(mix(0.0, unpackHalf2x16(h).x, 6000.0)) &&
            is(dot(unpackHalf2x16(h), vec2(6000.0, 0.0))) && is((unpackHalf2x16(h) * 6000.0).x) && is(vec3(unpackHalf2x16(h), 1.0).x * 6000.0) &&
            is(unpackHalf2x16(h).yx.y * 6000.0) && is(-unpackHalf2x16(h).x * -6000.0) && is(y) &&
            is((p.x > 0.0 ? unpackHalf2x16(h).x : 0.0) * 6000.0) && is(unpackHalf2x16(h).x * 5999.0 + 12.0) &&
            is(max(unpackHalf2x16(h).x * 6000.0, 1.0)) && unpackHalf2x16(h).x * 6000.0 < 72001.0;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

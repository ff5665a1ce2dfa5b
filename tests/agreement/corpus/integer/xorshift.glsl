uint next(inout uint s) { s ^= s << 13; s ^= s >> 17; s ^= s << 5; return s; }
void mainImage(out vec4 color, in vec2 p) {
  uint s = uint(p.x) * 1973u + uint(p.y) * 9277u + uint(iFrame) * 26699u + 1u;
  next(s); next(s);
  color = vec4(float(next(s) & 255u), float(next(s) >> 24), float(next(s) % 256u), 255.0) / 255.0;
}

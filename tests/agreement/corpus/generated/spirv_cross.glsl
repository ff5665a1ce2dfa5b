// Decompiled: names are numbers, loops are endless with a break, selections through booleans.
struct _11 { vec4 _m0; float _m1; };
_11 _48(vec2 _50) {
  _11 _52;
  _52._m0 = vec4(_50, 0.0, 1.0);
  _52._m1 = _50.x * 0.5;
  return _52;
}
void mainImage(out vec4 _61, in vec2 _62) {
  vec2 _70 = _62 / iResolution.xy;
  _11 _72 = _48(_70);
  float _75 = 0.0;
  int _76 = 0;
  for (;;) {
    bool _80 = _76 < 6;
    if (!_80) { break; }
    float _84 = fract(_72._m1 * float(_76 + 1));
    bool _86 = _84 > _70.y;
    float _88;
    if (_86) { _88 = 1.0; } else { _88 = 0.0; }
    _75 += _88;
    _76++;
    continue;
  }
  _61 = vec4(vec3(_75 / 6.0) * _72._m0.xyw, 1.0);
}

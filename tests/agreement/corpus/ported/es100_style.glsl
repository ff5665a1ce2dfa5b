// As WebGL 1 had it: constant loop bounds, no integers beyond counters, precision everywhere.
precision mediump float;
const lowp int steps = 12;
mediump float wave(highp float x) { return x * (1.0 - x) * 4.0; }
void mainImage(out lowp vec4 fragColor, in mediump vec2 fragCoord) {
  highp vec2 uv = fragCoord.xy / iResolution.xy;
  highp float value = uv.y;
  for (int i = 0; i < steps; i++) {
    if (float(i) > uv.x * 12.0) break;
    value = wave(value);
  }
  fragColor = vec4(value, value * value, 1.0 - value, 1.0);
}

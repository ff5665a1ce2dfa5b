// green = right. smoothstep(e, e, x) is 1 behind e and 0 elsewhere; reversed edges go down.
float edge(float e, float x) { return smoothstep(e, e, x); }
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), half_ = 0.5 + zero, x = 0.6 + zero, known = 0.25, kept = 3.0;
  kept = smoothstep(known, known, x);
  vec3 v = smoothstep(vec3(0.5, 0.25, 0.0), vec3(0.5, 0.25, 1.0), vec3(x, zero, x));
  bool ok = smoothstep(0.5, 0.5, x) == 1.0 && smoothstep(0.5, 0.5, half_) == 0.0 && smoothstep(0.5, 0.5, zero) == 0.0 &&
            smoothstep(half_, half_, x) == 1.0 && smoothstep(half_, half_, half_) == 0.0 && edge(0.5, x) == 1.0 && edge(x, zero) == 0.0 &&
            kept == 1.0 && v.x == 1.0 && v.y == 0.0 && v.z > 0.6 && v.z < 0.7 && smoothstep(1.0, 0.0, zero) == 1.0 &&
            smoothstep(1.0, 0.0, 2.0 + zero) == 0.0 && 1.0 - smoothstep(0.5, 0.5, smoothstep(0.1, 0.1, x)) * 2.0 == -1.0 &&
            smoothstep(0.5, 0.5, vec2(x, zero)) == vec2(1.0, 0.0);
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

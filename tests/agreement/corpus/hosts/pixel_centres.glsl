// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = fract(p) == vec2(0.5) && p == gl_FragCoord.xy && p.x < iResolution.x && p.y < iResolution.y;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

void mainImage(out vec4 color, in vec2 p) {
  if (mod(floor(p.x / 8.0) + float(iFrame), 2.0) > 0.5) discard;
  color = vec4(float(iFrame + 1) * 0.4, p.y / iResolution.y, 0.3, 1.0);
}

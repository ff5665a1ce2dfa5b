void mainImage(out vec4 color, in vec2 p) {
  vec2 c = floor(p / 16.0), f = fract(p / 16.0);
  int h = int(c.x) * 5 + int(c.y) * 3 + int(c.x * c.y);
  if ((h & 1) == 0) f.x = 1.0 - f.x;
  float d = min(abs(length(f) - 0.5), abs(length(f - 1.0) - 0.5));
  color = vec4(vec3(smoothstep(0.05, 0.15, d)), 1.0);
}

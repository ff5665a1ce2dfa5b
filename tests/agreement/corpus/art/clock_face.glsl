void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  float r = length(q), a = atan(q.x, q.y);
  float tick = abs(fract(a / 6.2831853 * 12.0 + 0.5) - 0.5);
  vec3 c = vec3(0.95);
  if (r > 0.95) c = vec3(0.2);
  else if (r > 0.8 && tick < 0.08) c = vec3(0.1);
  float hand = iTime * 0.1047198;
  vec2 d = vec2(sin(hand), cos(hand));
  if (dot(q, d) > 0.0 && dot(q, d) < 0.7 && abs(q.x * d.y - q.y * d.x) < 0.03) c = vec3(0.8, 0.1, 0.1);
  color = vec4(c, 1.0);
}

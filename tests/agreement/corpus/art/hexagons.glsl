void mainImage(out vec4 color, in vec2 p) {
  const vec2 s = vec2(1.0, 1.7320508);
  vec2 q = p / 14.0;
  vec4 c = floor(vec4(q, q - vec2(0.5, 1.0)) / s.xyxy) + 0.5;
  vec4 h = vec4(q - c.xy * s, q - (c.zw + 0.5) * s);
  vec2 id = dot(h.xy, h.xy) < dot(h.zw, h.zw) ? c.xy : c.zw + 9.43;
  color = vec4(fract(id * 0.27), fract(id.x * id.y * 0.11), 1.0);
}

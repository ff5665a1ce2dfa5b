float stroke(vec2 p, vec2 a, vec2 b) { vec2 d = b - a; return distance(p, a + d * clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0)); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = p / iResolution.y * 4.0;
  float d = min(stroke(q, vec2(1.0, 0.8), vec2(1.0, 3.2)), stroke(q, vec2(1.0, 3.2), vec2(2.2, 3.2)));
  d = min(d, stroke(q, vec2(1.0, 2.0), vec2(2.0, 2.0)));
  d = min(d, abs(distance(q, vec2(4.2, 2.0)) - 1.0));
  color = vec4(vec3(smoothstep(0.15, 0.2, d)), 1.0);
}

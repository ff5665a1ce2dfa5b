// Height in x, what it was before in y.
float h(ivec2 q) { return texelFetch(iChannel0, clamp(q, ivec2(0), ivec2(iResolution.xy) - 1), 0).x; }
void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  if (iFrame == 0) {
    vec2 d = p - vec2(40.5, 30.5);
    color = vec4(max(0.0, 1.0 - dot(d, d) / 64.0));
    return;
  }
  vec2 now = texelFetch(iChannel0, q, 0).xy;
  float force = h(q + ivec2(1, 0)) + h(q - ivec2(1, 0)) + h(q + ivec2(0, 1)) + h(q - ivec2(0, 1)) - 4.0 * now.x;
  color = vec4(2.0 * now.x - now.y + 0.25 * force, now.x, 0.0, 1.0);
}

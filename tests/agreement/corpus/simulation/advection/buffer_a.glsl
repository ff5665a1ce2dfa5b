// Carried along a field that turns, back along the stream, between texels.
vec2 field(vec2 p) { vec2 q = p - 0.5 * iResolution.xy; return vec2(-q.y, q.x) * 0.05; }
void mainImage(out vec4 color, in vec2 p) {
  if (iFrame == 0) { color = vec4(step(0.5, fract(p / 24.0)), 0.0, 1.0); return; }
  color = textureLod(iChannel0, (p - field(p)) / iResolution.xy, 0.0);
}

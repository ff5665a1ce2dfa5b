// A pass that reads itself and another one; discard keeps or clears.
#iChannel0 "self"
#iChannel1 "inputs/pattern.glsl"
void mainImage(out vec4 color, in vec2 p) {
  vec4 before = texelFetch(iChannel0, ivec2(p), 0), other = texelFetch(iChannel1, ivec2(p.yx) % 8, 0);
  if (iFrame == 1 && p.x < 3.0) discard;
  color = before * 0.5 + other + float(iFrame);
}

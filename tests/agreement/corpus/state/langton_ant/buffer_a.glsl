// The ant's place and direction stand in the lower left texel's g, b and a; the grid is in r.
void mainImage(out vec4 color, in vec2 position) {
  ivec2 p = ivec2(position);
  vec4 own = texelFetch(iChannel0, p, 0);
  vec4 ant = texelFetch(iChannel0, ivec2(0), 0);
  if (iFrame == 0) {
    color = vec4(float((p.x / 3 + p.y / 2) % 2), vec3(0.0));
    if (p == ivec2(0)) color.gba = vec3(40.0, 30.0, 0.0);
    return;
  }
  ivec2 at = ivec2(ant.gb);
  color = own;
  if (p == at) color.r = 1.0 - own.r;
  if (p == ivec2(0)) {
    int turn = int(ant.a) + (texelFetch(iChannel0, at, 0).r > 0.5 ? 1 : 3);
    turn %= 4;
    const ivec2 steps[4] = ivec2[4](ivec2(0, 1), ivec2(1, 0), ivec2(0, -1), ivec2(-1, 0));
    color.gba = vec3(vec2(at + steps[turn]), float(turn));
  }
}

#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) {
  float levels[3];
  levels[int(p.x) % 3] = texture(iChannel0, p / iResolution.xy).x;
  st_assert(levels[0] >= 0.0);
  c = vec4(levels[0], levels[1], iCh0.size.xy);
}
void mainVR(out vec4 c, in vec2 p, in vec3 origin, in vec3 direction) { c = vec4(direction, 1.0); }

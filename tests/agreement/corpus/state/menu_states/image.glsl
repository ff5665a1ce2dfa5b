void mainImage(out vec4 color, in vec2 p) {
  vec4 s = texelFetch(iChannel0, ivec2(0), 0);
  int column = int(p.x / iResolution.x * 4.0);
  color = vec4(column == int(s.x), s.y / 4.0, s.z / 40.0, 1.0);
}

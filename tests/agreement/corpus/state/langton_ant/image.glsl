void mainImage(out vec4 color, in vec2 p) {
  vec4 ant = texelFetch(iChannel0, ivec2(0), 0);
  float cell = texelFetch(iChannel0, ivec2(p), 0).r;
  color = ivec2(p) == ivec2(ant.gb) ? vec4(1.0, 0.0, 0.0, 1.0) : vec4(vec3(cell), 1.0);
}

void mainImage(out vec4 color, in vec2 p) {
  vec4 other = texelFetch(iChannel0, ivec2(p), 0);
  color = iFrame == 0 ? vec4(mod(p, 16.0) / 16.0, 0.0, 1.0) : vec4(other.yzx * 0.9 + 0.05, 1.0);
}

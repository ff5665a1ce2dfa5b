// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = textureSize(iChannel1, 0) == ivec2(1) && texelFetch(iChannel1, ivec2(0), 0) == vec4(0.0, 0.0, 0.0, 1.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = texture(iChannel0, p) == vec4(0, 0, 0, 1) && iChannelResolution[0] == vec3(0.0) && iChannelTime[0] == 0.0;
  ok = ok && textureLod(iChannel3, p, 2.0) == vec4(0, 0, 0, 1);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

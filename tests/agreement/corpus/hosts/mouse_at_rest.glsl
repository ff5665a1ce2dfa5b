// green
void mainImage(out vec4 color, in vec2 p) {
  bool ok = iMouse == vec4(0.0) && iFrame >= 0 && iResolution.z == 1.0 && iSampleRate == 44100.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

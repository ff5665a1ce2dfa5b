// Reverses and counts bits without the functions of later versions.
uint reversed(uint v) {
  v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
  v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
  v = ((v >> 4) & 0x0F0F0F0Fu) | ((v & 0x0F0F0F0Fu) << 4);
  return ((v >> 8) & 0xFFu) | ((v & 0xFFu) << 8);
}
void mainImage(out vec4 color, in vec2 p) {
  uint r = reversed(uint(p.x) * 512u) & 0xffffu;
  float van_der_corput = float(r) / 128.0;
  color = vec4(vec3(step(p.y / iResolution.y, fract(van_der_corput))), 1.0);
}

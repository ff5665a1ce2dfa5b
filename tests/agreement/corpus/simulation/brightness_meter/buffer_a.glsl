// The mean of the last picture, by the smallest mipmap, moves an exposure.
void mainImage(out vec4 color, in vec2 p) {
  float mean = textureLod(iChannel0, vec2(0.5), 20.0).r;
  float exposure = iFrame == 0 ? 1.0 : mean < 0.4 ? 1.25 : 0.75;
  color = vec4(exposure * fract(floor(p.x / 8.0) * 0.125), exposure, 0.0, 1.0);
}

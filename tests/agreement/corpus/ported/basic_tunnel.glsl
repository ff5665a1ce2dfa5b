// A demo of the nineties: angle and inverse distance look up a texture that is made on the spot.
int tex(int u, int v) { return ((u ^ v) & 255); }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  vec2 c = fragCoord - 0.5 * iResolution.xy;
  float d = length(c) + 0.5;
  int u = int(32.0 * 64.0 / d) + int(iTime * 16.0);
  int v = int(256.0 * (atan(c.y, c.x) / 6.2831853 + 0.5));
  float shade = min(d / 40.0, 1.0);
  fragColor = vec4(vec3(tex(u & 255, v & 255)) / 255.0 * vec3(1.0, 0.8, 0.5) * shade, 1.0);
}

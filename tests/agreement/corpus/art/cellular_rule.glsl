// Rule 30 computed anew for every pixel from the top row down.
void mainImage(out vec4 color, in vec2 p) {
  uint row = 1u << 16;
  int steps = int(iResolution.y - p.y) / 4;
  for (int i = 0; i < steps; ++i) row = (row << 1) ^ (row | (row >> 1));
  color = vec4(vec3((row >> uint(31 - int(p.x) / 4)) & 1u), 1.0);
}

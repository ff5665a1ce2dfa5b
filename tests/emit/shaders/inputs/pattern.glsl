// Something to sample, other in every pixel and frame.
void mainImage(out vec4 color, in vec2 p) {
  uint h = uint(p.x) * 374761393u + uint(p.y) * 668265263u + uint(iFrame) * 2246822519u;
  h = (h ^ (h >> 13)) * 1274126177u;
  color = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, h >> 24) / 255.0 * 4.0 - 1.0;
}

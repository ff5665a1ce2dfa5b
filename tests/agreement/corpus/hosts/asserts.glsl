void mainImage(out vec4 color, in vec2 p) {
  color = vec4(0.2, 0.4, 0.6, 1.0);
  if (p.x < 8.0 && p.y < 0.0) st_assert(false);
}

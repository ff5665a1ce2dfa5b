const mat4 bayer = mat4(0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  float limit = (bayer[q.x & 3][q.y & 3] + 0.5) / 16.0;
  color = vec4(vec3(step(limit, p.x / iResolution.x)), 1.0);
}

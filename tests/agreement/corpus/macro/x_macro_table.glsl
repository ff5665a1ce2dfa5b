#define SHAPES(X) X(0, 0.2, 0.3) X(1, 0.5, 0.6) X(2, 0.8, 0.4)
#define DIST(index, px, py) d[index] = distance(uv, vec2(px, py) * vec2(aspect, 1.0));
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.y;
  float aspect = iResolution.x / iResolution.y;
  float d[3];
  SHAPES(DIST)
  color = vec4(step(0.15, d[0]), step(0.2, d[1]), step(0.1, d[2]), 1.0);
}

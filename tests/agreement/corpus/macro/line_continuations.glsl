#define CELL(p) \
  { \
    vec2 id = floor(p); \
    acc += vec3(mod(id.x, 3.0), mod(id.y, 2.0), \
                mod(id.x + id.y, 4.0)) / \
           vec3(3.0, 2.0, 4.0); \
  }
void mainImage(out vec4 color, in vec2 p) {
  vec3 acc = vec3(0.0);
  CELL(p / 8.0)
  CELL(p / 13.0 + 0.5)
  color = vec4(acc * 0.5, 1.0);
}

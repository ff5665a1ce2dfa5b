// green
float list[3] = float[3](1.0, 2.0, 4.0);
void mainImage(out vec4 color, in vec2 p) {
  int big = 5 + int(p.x), small = -1 - int(p.y);
  vec3 v = vec3(1.0, 2.0, 4.0);
  bool ok = list[big] == 4.0 && list[small] == 1.0 && v[big] == 4.0 && mat2(1.0, 2.0, 3.0, 4.0)[big] == vec2(3.0, 4.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// green
const float half_pi = acos(0.0);
const int size = 2 + 3 * 2;
const ivec2 pair = ivec2(size, size - 1);
const float table[size / 2] = float[](1.0, 2.0, 4.0, 8.0);
const mat2 m = mat2(1.0, 2.0, 3.0, 4.0) * 2.0;
void mainImage(out vec4 color, in vec2 p) {
  const vec3 c = vec3(min(1.0, 2.0), max(3.0, 2.0), floor(2.5));
  float list[pair.y];
  bool ok = abs(half_pi - 1.5707963) < 1e-5 && list.length() == 7 && table[pair.x / 4] == 4.0 && m[1] == vec2(6.0, 8.0) && c == vec3(1.0, 3.0, 2.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

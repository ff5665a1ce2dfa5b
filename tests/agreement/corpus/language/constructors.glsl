// green
void mainImage(out vec4 color, in vec2 p) {
  float z = 0.0 * p.y;
  vec4 a = vec4(vec2(1.0 + z, 2.0), ivec2(3, 4));
  ivec3 b = ivec3(1.9, true, uint(7));
  mat3 c = mat3(mat2(1.0, 2.0, 3.0, 4.0 + z));
  bvec2 d = bvec2(z, 2.5);
  vec3 e = vec3(a);
  mat4 f = mat4(c);
  bool ok = a.wzyx == vec4(4.0, 3.0, 2.0, 1.0) && b == ivec3(1, 1, 7) && c[2] == vec3(0.0, 0.0, 1.0) && d == bvec2(false, true);
  ok = ok && e == vec3(1.0, 2.0, 3.0) && f[3] == vec4(0.0, 0.0, 0.0, 1.0) && f[1].xy == vec2(3.0, 4.0) && int(bool(3)) == 1;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

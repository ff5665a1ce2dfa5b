// green
void mainImage(out vec4 color, in vec2 p) {
  float z = 0.0 * p.x;
  mat2x3 a = mat2x3(1.0 + z, 2.0, 3.0, 4.0, 5.0, 6.0);
  mat3x2 b = transpose(a);
  mat2 c = b * a;
  mat3 d = a * b;
  mat3 e = mat3(2.0);
  e[1] = vec3(1.0, 3.0, 5.0);
  e[2][0] += 7.0;
  vec3 r = vec3(1.0, 2.0, 3.0) * e;
  bool ok = c == mat2(14.0, 32.0, 32.0, 77.0) && d[2] == vec3(27.0, 36.0, 45.0) && r == vec3(2.0, 22.0, 13.0);
  ok = ok && determinant(mat2(3.0, 1.0, 4.0, 2.0 + z)) == 2.0 && inverse(mat2(2.0, 0.0, 0.0, 4.0 + z)) == mat2(0.5, 0.0, 0.0, 0.25);
  ok = ok && matrixCompMult(mat2(1.0, 2.0, 3.0, 4.0), mat2(2.0)) == mat2(2.0, 0.0, 0.0, 8.0) && outerProduct(vec2(1.0, 2.0), vec2(3.0, 4.0)) == mat2(3.0, 6.0, 4.0, 8.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

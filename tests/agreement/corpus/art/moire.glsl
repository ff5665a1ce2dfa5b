void mainImage(out vec4 color, in vec2 p) {
  vec2 a = p - vec2(40.0, 36.0), b = p - vec2(90.0, 40.0);
  int m = int(sqrt(dot(a, a))) / 4 + int(sqrt(dot(b, b))) / 4;
  color = vec4(vec3(m & 1), 1.0);
}

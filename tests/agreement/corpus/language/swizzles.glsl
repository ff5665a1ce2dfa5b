// green
void mainImage(out vec4 color, in vec2 p) {
  vec4 v = vec4(1.0, 2.0, 3.0, 4.0 + 0.0 * p.x);
  v.xz = v.zx;
  vec3 w = v.stp;
  w.gb += v.rr;
  v.wzyx = v;
  ivec3 i = ivec3(4, 5, 6);
  i.zx = i.xz + 10;
  bvec2 b = bvec2(true, false).yx;
  bool ok = v == vec4(4.0, 1.0, 2.0, 3.0) && w == vec3(3.0, 5.0, 4.0) && i == ivec3(16, 5, 14) && b == bvec2(false, true) && v.xyzw.zw.y == 3.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

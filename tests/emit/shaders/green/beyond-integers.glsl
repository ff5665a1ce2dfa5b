// green = right. What an int or a uint can't hold gives the nearest that it can hold; NaN gives 0.
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), nan = zero / zero, infinite = 1.0 / zero;
  bool ok = int(3e9 + zero) == 2147483647 && int(-3e9 - zero) == -2147483647 - 1 && int(infinite) == 2147483647 &&
            int(-infinite) == -2147483647 - 1 && int(nan) == 0 && int(2147483648.0 + zero) == 2147483647 &&
            int(2147483520.0 + zero) == 2147483520 && int(-4.5 - zero) == -4 && int(floor(zero - 0.5)) == -1 &&
            uint(-4.5 + zero) == 0u && uint(-1.0 - zero) == 0u && uint(5e9 + zero) == 4294967295u && uint(3e9 + zero) == 3000000000u &&
            uint(nan) == 0u && uint(infinite) == 4294967295u && uint(-infinite) == 0u && uint(2.75 + zero) == 2u;
  ivec3 v = ivec3(vec2(-3e9, 7.5) + zero, nan);
  uvec2 u = uvec2(zero - 1.0, 9.5);
  int list[3] = int[3](4, 5, 6);
  ok = ok && v == ivec3(-2147483647 - 1, 7, 0) && u == uvec2(0u, 9u) && ivec2(p.xy + 1e10) == ivec2(2147483647) &&
       list[int(infinite)] == 6 && int(float(int(4.5 + zero))) == 4 && ivec2(int(zero + 1.5), zero - 2.5) == ivec2(1, -2) &&
       uvec2(zero + 3e10) == uvec2(4294967295u) && float(uint(vec2(zero - 3.0, 1.0))) == 0.0;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

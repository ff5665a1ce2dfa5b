void mainImage(out vec4 color, in vec2 p) {
  color = vec4(0.0);
  float best = 1e9;
  for (int y = -3; y <= 3; ++y)
    for (int x = -3; x <= 3; ++x) {
      ivec2 q = ivec2(p) + ivec2(x, y) * 7;
      for (int k = 0; k < 9; ++k) {
        ivec2 r = q + ivec2(k % 3 - 1, k / 3 - 1) * 2;
        if (r.x < 0 || r.y < 0 || r.x >= int(iResolution.x) || r.y >= int(iResolution.y)) continue;
        vec4 s = texelFetch(iChannel0, r, 0);
        vec2 d = s.xy - p;
        if (s.z > 0.0 && dot(d, d) < best) { best = dot(d, d); color = s; }
      }
    }
}

void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec3 c = vec3(0.0);
  for (int i = 0; i < 16; ++i) {
    vec4 q = texelFetch(iChannel0, ivec2(i, 0), 0);
    vec2 d = abs(uv - q.xy);
    if (max(d.x, d.y) < 0.03) c += vec3(0.5, 0.0625 * float(i), 0.3);
  }
  color = vec4(c, 1.0);
}

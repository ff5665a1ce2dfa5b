void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec3 c = textureLod(iChannel0, uv, 0.0).rgb * 0.5;
  for (int level = 1; level < 5; ++level) c += textureLod(iChannel0, uv, float(level)).rgb / float(2 << level);
  color = vec4(c / (1.0 + c), 1.0);
}

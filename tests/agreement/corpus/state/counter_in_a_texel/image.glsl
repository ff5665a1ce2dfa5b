void mainImage(out vec4 color, in vec2 p) {
  vec2 ball = texelFetch(iChannel0, ivec2(0, 0), 0).xy;
  vec2 score = texelFetch(iChannel0, ivec2(2, 0), 0).xy;
  vec2 uv = p / iResolution.xy;
  vec2 d = abs(uv - ball);
  color = vec4(step(max(d.x, d.y), 0.06), score / 8.0, 1.0);
}

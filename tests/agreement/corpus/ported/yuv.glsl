const mat3 to_yuv = mat3(0.299, -0.147, 0.615, 0.587, -0.289, -0.515, 0.114, 0.436, -0.1);
const mat3 to_rgb = mat3(1.0, 1.0, 1.0, 0.0, -0.395, 2.032, 1.14, -0.581, 0.0);
vec3 bars(float x) {
  int n = 7 - int(x * 8.0);
  return 0.75 * vec3(float((n >> 1) & 1), float((n >> 2) & 1), float(n & 1));
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  vec3 yuv = to_yuv * bars(uv.x);
  float chroma = uv.y < 0.5 ? 1.0 : 2.0 * (1.0 - uv.y);
  color = vec4(to_rgb * vec3(yuv.x, yuv.yz * chroma), 1.0);
}

#define ENTRY(name) void name(out vec4 color, in vec2 p)
#define fragment mainImage
#define PIXEL (p / iResolution.xy)
ENTRY(fragment) {
  vec2 uv = PIXEL;
  color = vec4(step(uv.x, uv.y), uv, 1.0);
}

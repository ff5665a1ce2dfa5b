// Surfaces of an engine have v downwards, colours in linear light.
#define _MainTex iChannel0
#define TRANSFORM_TEX(uv, st) ((uv) * (st).xy + (st).zw)
struct v2f { vec4 vertex; vec2 uv; };
struct appdata { vec4 vertex; vec2 texcoord; };
v2f vert(appdata v) { v2f o; o.vertex = v.vertex; o.uv = TRANSFORM_TEX(v.texcoord, vec4(2.0, 1.5, 0.25, 0.0)); return o; }
vec4 frag(v2f i) {
  vec2 c = floor(i.uv * 4.0) / 4.0;
  return vec4(c.x * 0.4, 1.0 - c.y * 0.5, step(0.5, fract(i.uv.x)), 1.0);
}
vec3 to_display(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
void mainImage(out vec4 fragColor, in vec2 fragCoord) {
  appdata v;
  v.vertex = vec4(fragCoord, 0.0, 1.0);
  v.texcoord = vec2(fragCoord.x, iResolution.y - fragCoord.y) / iResolution.xy;
  vec4 c = frag(vert(v));
  fragColor = vec4(to_display(clamp(c.rgb, 0.0, 1.0)), c.a);
}

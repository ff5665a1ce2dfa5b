// Mipmapped and linear sampling with the level chosen from the neighbouring pixels, also where they part.
#iChannel0 "inputs/pattern.glsl"
#iChannel0::MinFilter "LinearMipMapLinear"
#iChannel0::WrapMode "Repeat"
void mainImage(out vec4 color, in vec2 p) {
  vec2 uv = p / iResolution.xy;
  color = texture(iChannel0, uv * 3.7);
  if (p.x > 8.0) color += texture(iChannel0, uv * uv.x * 5.0, 0.5);
  color += textureLod(iChannel0, uv, 1.5) + textureGrad(iChannel0, uv, vec2(0.2, 0.0), vec2(0.0, 0.1));
}

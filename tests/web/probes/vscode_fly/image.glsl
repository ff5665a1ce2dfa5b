#iChannel0 "view.glsl"

void mainImage(out vec4 color, in vec2 at) {
  color = texelFetch(iChannel0, ivec2(at), 0);
}

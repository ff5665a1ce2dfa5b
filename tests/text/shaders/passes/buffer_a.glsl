#iChannel0 "buffer_a.glsl"
#iChannel1 "cubemap_a.glsl"
void mainImage(out vec4 c, in vec2 p) {
  c = texelFetch(iChannel0, ivec2(p), 0) + texture(iChannel1, vec3(p, 1.0)) * wave(iTime, 1.0);
}

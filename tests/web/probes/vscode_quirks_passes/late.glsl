#iChannel0 "self"
#iChannel1 "plain.glsl"
void mainImage(out vec4 c, in vec2 p) { c = vec4(iFrame + 1, float(iFrame), texelFetch(iChannel0, ivec2(0), 0).x, 1); }

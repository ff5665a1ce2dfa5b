#iChannel2 "first.glsl"
void mainImage(out vec4 c, in vec2 p)
{
    c = texelFetch(iChannel2, ivec2(p), 0);
}

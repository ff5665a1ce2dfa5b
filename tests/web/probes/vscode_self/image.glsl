#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p)
{
    c = texelFetch(iChannel0, ivec2(p), 0) + vec4(1.0, 0.0, 0.0, 0.25);
}

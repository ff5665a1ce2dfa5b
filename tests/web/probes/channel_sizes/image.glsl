void mainImage(out vec4 c, in vec2 p)
{
    c = texelFetch(iChannel0, ivec2(p), 0);
}

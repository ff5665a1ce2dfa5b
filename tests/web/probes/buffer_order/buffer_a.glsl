void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(iFrame, texelFetch(iChannel0, ivec2(p), 0).x, 0.0, 0.0);
}

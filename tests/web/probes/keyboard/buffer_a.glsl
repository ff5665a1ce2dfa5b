void mainImage(out vec4 c, in vec2 p)
{
    ivec2 key = ivec2(65, int(p.y));
    c = int(p.x) == iFrame ? texelFetch(iChannel1, key, 0) : texelFetch(iChannel0, ivec2(p), 0);
    if (int(p.x) == 7)
        c = vec4(iChannelResolution[1], 0.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    c = int(p.x) == iFrame ? vec4(iTime, iTimeDelta, 0.0, 0.0) : texelFetch(iChannel0, ivec2(p), 0);
}

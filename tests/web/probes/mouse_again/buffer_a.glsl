void mainImage(out vec4 c, in vec2 p)
{
    c = int(p.x) == iFrame ? iMouse : texelFetch(iChannel0, ivec2(p), 0);
}

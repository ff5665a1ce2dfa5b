#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p)
{
    c = texelFetch(iChannel0, ivec2(p), 0);
    if (int(p.x) == iFrame) c = p.y < 1.0 ? iMouse : vec4(iTimeDelta, texture(iChannel3, vec2(0.5)).ra, 1.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    ivec2 at[4] = ivec2[4](ivec2(8, 0), ivec2(0, 8), ivec2(-1, 0), ivec2(7, 7));
    c = texelFetch(iChannel0, at[int(p.x) % 4] + iFrame, 0);
}

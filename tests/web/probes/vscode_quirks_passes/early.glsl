#iChannel0 "self"
#iChannel1 "late.glsl"
#iChannel2 "plain.glsl"
void mainImage(out vec4 c, in vec2 p)
{
    c = texelFetch(iChannel0, ivec2(p), 0);
    if (int(p.x) == iFrame) c = vec4(texelFetch(iChannel1, ivec2(0), 0).xyz, texelFetch(iChannel2, ivec2(0), 0).x);
}

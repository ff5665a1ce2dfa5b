void mainImage(out vec4 c, in vec2 p)
{
    vec4 last = texelFetch(iChannel0, ivec2(p), 0);
    c = vec4(last.x + float(iFrame == 0), iFrame, last.z + 1.0, 0.0);
}

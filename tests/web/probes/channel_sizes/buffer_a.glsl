void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(iChannelResolution[int(p.x) % 2], 0.0);
}

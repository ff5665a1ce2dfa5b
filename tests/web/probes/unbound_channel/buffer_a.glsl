void mainImage(out vec4 c, in vec2 p)
{
    c = p.x < 1.0 ? texture(iChannel3, vec2(0.3)) : vec4(iChannelResolution[3], 7.0);
}

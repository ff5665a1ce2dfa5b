void mainImage(out vec4 c, in vec2 p)
{
    vec2 uv = (floor(p) + 0.5) / 2.0;
    c = p.x < 2.0 ? texture(iChannel0, uv) : vec4(iChannelResolution[0], 0.0);
}

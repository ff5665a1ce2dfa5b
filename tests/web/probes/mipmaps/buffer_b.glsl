void mainImage(out vec4 c, in vec2 p)
{
    c = textureLod(iChannel0, vec2(0.5), 9.0);
}

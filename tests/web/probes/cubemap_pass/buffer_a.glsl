void mainImage(out vec4 c, in vec2 p)
{
    if (iFrame == 0)
        c = texture(iChannel0, vec3(1.0, 0.0, 0.0));
    else
        c = texelFetch(iChannel1, ivec2(p), 0);
}

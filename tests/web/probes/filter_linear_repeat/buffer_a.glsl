void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(floor(p), 0.0, 1.0);
}

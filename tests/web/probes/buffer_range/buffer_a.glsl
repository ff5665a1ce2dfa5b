void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(-3.5, 1000.25, 1e30, -1e-30);
}

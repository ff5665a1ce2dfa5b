void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(2 * int(p.x) + 100 * iFrame, p.y, 0.0, 1.0);
}

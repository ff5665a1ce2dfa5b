void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(TWICE(p.x), add(p.x, p.y), 0.0, 1.0);
}

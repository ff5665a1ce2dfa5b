void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(add(0.25, TWICE(0.375)), 0.0, 0.0, 1.0);
}

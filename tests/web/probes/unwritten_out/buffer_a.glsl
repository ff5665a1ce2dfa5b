void nothing(out vec2 x)
{
    if (iFrame > 100)
        x = vec2(3.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    vec2 a = vec2(5.0, 6.0) + p;
    nothing(a);
    c = vec4(a, 1.0, 1.0);
}

float tall(float y)
{
    if (y > 4.0)
        return 7.0;
}

void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(tall(p.y), 1.0, 1.0, 1.0);
}

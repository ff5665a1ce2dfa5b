void mainImage(out vec4 c, in vec2 p)
{
    if (iFrame == 1 && p.x > 4.0)
        discard;
    c = vec4(iFrame, 1 - iFrame, 0.0, 1.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    c = p.x < 4.0 ? vec4(p, fract(p)) : vec4(iResolution, 1.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    vec2 at[5] = vec2[5](vec2(1.5, 3.5), vec2(2.0, 3.0), vec2(8.75, 0.5), vec2(-0.25, 0.5), vec2(1.9, 7.75));
    c = texture(iChannel0, at[int(p.x) % 5] / 8.0);
}

void mainImage(out vec4 c, in vec2 p)
{
    vec3 at[4] = vec3[4](vec3(1.0, 0.0, 0.0), vec3(-0.6, 0.8, 0.0), vec3(0.48, -0.6, 0.64), vec3(0.0, 0.28, -0.96));
    c = int(p.x) < 4 ? texture(iChannel0, at[int(p.x)]) : vec4(iChannelResolution[0], 1.0);
}

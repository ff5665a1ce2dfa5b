void mainImage(out vec4 c, in vec2 p)
{
    vec3 d[7] = vec3[7](vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1),
                        vec3(1.0, 0.5, 0.5));
    int i = int(p.x);
    c = i < 7 ? textureLod(iChannel0, d[i], 0.0) : vec4(iChannelResolution[0], 0.5);
}

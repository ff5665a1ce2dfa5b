void mainImage(out vec4 c, in vec2 p)
{
    float a[4] = float[4](1.0, 2.0, 3.0, 4.0);
    vec3 v = vec3(5.0, 6.0, 7.0);
    mat2 m = mat2(8.0, 9.0, 10.0, 11.0);
    int far = 100 + iFrame;
    c = vec4(a[far], a[-far], v[far], m[far][1]);
}

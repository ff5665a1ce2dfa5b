#iChannel0 "values.glsl"
void mainImage(out vec4 c, in vec2 p)
{
    c = texture2D(iChannel0, p / iResolution.xy);
}

float saturate(float x) { return clamp(x, 0.0, 1.0); }
#define texture2D(s, p) vec4(0.5)
void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(saturate(p.x), texture2D(iChannel0, p).x, HW_PERFORMANCE, 1.0);
}

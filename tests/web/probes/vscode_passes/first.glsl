#include "shared.glsl"
void mainImage(out vec4 c, in vec2 p)
{
    c = vec4(float(iFrame) / 4.0, shared_value(), 0.0, 1.0);
}

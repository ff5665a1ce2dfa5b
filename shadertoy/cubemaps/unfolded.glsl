// The six faces of a cubemap, unfolded: how the pictures beside this file fit together.
//
// Seen from inside. Left to right: -X, -Z, +X, +Z; above and below -Z: +Y and -Y. Every edge inside the cross continues.

#ifdef SHADER_TOY
#iChannel0 "forest_{}.jpg"
#iChannel0::Type "CubeMap"
#iChannel1 "city_{}.jpg"
#iChannel1::Type "CubeMap"
#endif

// 0: the forest (iChannel0). 1: the city (iChannel1).
#ifndef CUBEMAP
#define CUBEMAP 0
#endif
#if CUBEMAP < 0 || CUBEMAP > 1
#error CUBEMAP is 0 (forest) or 1 (city)
#endif

// What lies at `at`, in [-1, 1], on the face that looks along `forward`, seen from the centre with `up` upwards.
vec3 onFace(vec3 forward, vec3 up, vec2 at)
{
    vec3 right = cross(forward, up);
    vec3 direction = forward + at.x * right + at.y * up;
#if CUBEMAP == 0
    return texture(iChannel0, direction).rgb;
#else
    return texture(iChannel1, direction).rgb;
#endif
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    // 4 x 3 cells, as large as the picture allows.
    float cell = min(iResolution.x / 4.0, iResolution.y / 3.0);
    vec2 grid = (fragCoord - 0.5 * iResolution.xy) / cell + vec2(2.0, 1.5);
    vec2 at = 2.0 * fract(grid) - 1.0;
    int column = int(floor(grid.x));
    int row = int(floor(grid.y));

    vec3 color = vec3(1.0);
    if (row == 1 && column >= 0 && column < 4) {
        vec3 forward = column == 0   ? vec3(-1.0, 0.0, 0.0)
                       : column == 1 ? vec3(0.0, 0.0, -1.0)
                       : column == 2 ? vec3(1.0, 0.0, 0.0)
                                     : vec3(0.0, 0.0, 1.0);
        color = onFace(forward, vec3(0.0, 1.0, 0.0), at);
    } else if (column == 1 && row == 2) {
        color = onFace(vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0), at);
    } else if (column == 1 && row == 0) {
        color = onFace(vec3(0.0, -1.0, 0.0), vec3(0.0, 0.0, -1.0), at);
    }
    fragColor = vec4(color, 1.0);
}

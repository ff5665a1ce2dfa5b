// Path tracer, Buffer B: orbit and zoom. Optional: without it the scene keeps its own view.
//
// Hold a mouse button: the camera moves in towards the target, and dragging orbits around it. Release: it moves back to
// where it started and keeps the angles. Needs nothing but iMouse.
//
// Texel 0: azimuth and elevation in turns (elevation from straight below), distance, 1 when one of them just changed.
// Texel 1: mouse position, 1 while a button is down, number of the scene + 1. Texel 2: resolution.

#ifdef SHADER_TOY
#iChannel0 "self"
#iChannel0::MinFilter "Nearest"
#iChannel0::MagFilter "Nearest"
#iChannel0::WrapMode "Clamp"
#include "scenes/select.glsl"
#include "common.glsl"
#endif

// Speed of the zoom: the way left shrinks by this factor's exponent a second. 6: 1 % is left after 0.77 s.
#ifndef CAMERA_EASE
#define CAMERA_EASE 6.0
#endif

// Turns per drag over the whole width; half of it per height.
#ifndef CAMERA_TURNS
#define CAMERA_TURNS 1.0
#endif

// Part of the way to `target` after dt seconds: the same at every frame rate. Arrives within a thousandth, so that the
// picture comes to rest.
float ease(float reach, float target, float dt)
{
    float left = (reach - target) * portableExp2((-1.44269504 * CAMERA_EASE) * clamp(dt, 0.0, 10.0));
    return abs(left) <= 0.001 * target ? target : target + left;
}

// The orbit after one frame. drag is in parts of the picture.
vec3 moveCamera(vec3 orbit, vec2 drag, bool down, float dt)
{
    vec2 elevations = (vec2(CAMERA_MIN_ELEVATION, CAMERA_MAX_ELEVATION) + 90.0) * 0.00277777778;
    float target = clamp(down ? CAMERA_MIN_ZOOM : CAMERA_DISTANCE, CAMERA_MIN_ZOOM, CAMERA_MAX_ZOOM);
    float azimuth = fract(orbit.x - CAMERA_TURNS * drag.x);
    float elevation = clamp(orbit.y - 0.5 * CAMERA_TURNS * drag.y, elevations.x, elevations.y);
    return vec3(azimuth, elevation, clamp(ease(orbit.z, target, dt), CAMERA_MIN_ZOOM, CAMERA_MAX_ZOOM));
}

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    ivec2 texel = ivec2(fragCoord);
    vec4 orbit = texelFetch(iChannel0, ivec2(0, 0), 0);
    int last = int(iResolution.x) - 1;
    vec4 mouse = texelFetch(iChannel0, ivec2(min(1, last), 0), 0);
    vec4 size = texelFetch(iChannel0, ivec2(min(2, last), 0), 0);

    float scene = float(SCENE_NAME) + 1.0;
    bool fresh = iFrame == 0 || mouse.w != scene;
    bool resized = !fresh && size.xy != iResolution.xy;
    bool down = iMouse.z > 0.0;
    bool dragging = down && mouse.z > 0.0 && !fresh && !resized;
    vec2 drag = dragging ? clamp((iMouse.xy - mouse.xy) / iResolution.xy, -1.0, 1.0) : vec2(0.0);

    vec3 before = fresh ? CAMERA_ORBIT.xyz : orbit.xyz;
    vec3 after = fresh ? before : moveCamera(before, drag, down, iTimeDelta);
    // More than a float rounds: where the arithmetic is double, what was stored comes back rounded.
    bool moved = resized || max3(abs(after - before)) > 1.0e-5 || (fresh && iFrame != 0);

    fragColor = vec4(0.0);
    if (texel == ivec2(0, 0)) {
        fragColor = vec4(after, moved ? 1.0 : 0.0);
    } else if (texel == ivec2(1, 0)) {
        fragColor = vec4(iMouse.xy, down ? 1.0 : 0.0, scene);
    } else if (texel == ivec2(2, 0)) {
        fragColor = vec4(iResolution.xy, 0.0, 0.0);
    }
}

// The orbit camera. Functions: 0 GetCameraVectors, x: (orbit), target. y: position, forward, up, right.
// 1 moveCamera, x: (orbit, seconds a frame), (drag, 1 for a button, frames). y: orbit afterwards, last zoom but one.
#include "../../shadertoy/scenes/fuzzy_refraction.glsl"
#include "../../shadertoy/common.glsl"
#undef SHADER_TOY
#define mainImage cameraImage
#include "../../shadertoy/camera.glsl"
#undef mainImage

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    if (iFrame == 0) {
        vec3 position;
        vec3 forward;
        vec3 up;
        vec3 right;
        GetCameraVectors(x[0].xyz, x[1].xyz, position, forward, up, right);
        y[0].xyz = position;
        y[1].xyz = forward;
        y[2].xyz = up;
        y[3].xyz = right;
    } else {
        vec3 orbit = x[0].xyz;
        float before = orbit.z;
        for (int i = 0; i < int(x[1].w); i++) {
            before = orbit.z;
            orbit = moveCamera(orbit, x[1].xy, x[1].z > 0.0, x[0].w);
        }
        y[0] = vec4(orbit, before);
    }
}

#include "probe.glsl"

// The mean of SAMPLES paths of the stage through the scene's own camera.
#include "stage.glsl"
#include "../../shadertoy/common.glsl"
#include "stage.glsl"
#undef SHADER_TOY
#define mainImage traceImage
#include "../../shadertoy/P3D_RT.glsl"
#undef mainImage

#ifndef SAMPLES
#define SAMPLES 16
#endif

void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec3 eye = vec3(0.0);
    vec3 forward = vec3(0.0);
    vec3 up = vec3(0.0);
    vec3 right = vec3(0.0);
    GetCameraVectors(CAMERA_ORBIT.xyz, CAMERA_AT, eye, forward, up, right);
    Camera cam = createCameraFromVectors(eye, right, up, -forward, CAMERA_DISTANCE, CAMERA_FOVY,
                                         iResolution.x / iResolution.y, CAMERA_APERTURE, CAMERA_FOCUS, 0.0, 1.0);
    uvec2 pixel = uvec2(fragCoord);
    fragColor = vec4(0.0);
    for (int i = 0; i < SAMPLES; i++) {
        uvec3 stream = uvec3(pixel, uint(i));
        vec4 xi = random4(stream, DIMENSION_LENS);
        Ray ray = getRay(cam, (vec2(pixel) + xi.xy) / iResolution.xy, vec3(xi.zw, 0.0));
        fragColor = accumulate(fragColor, rayColor(ray, stream));
    }
}

// createCamera and getRay. x: eye, at, up, (fovy, aspect, aperture, focusDist), (time0, time1, pixel_sample), xi.
// y: (origin, time), direction, u, v, n.
#include "../../shadertoy/common.glsl"

void probe(uint index, vec4 x[INPUTS], inout vec4 y[OUTPUTS])
{
    Camera cam = createCamera(x[0].xyz, x[1].xyz, x[2].xyz, x[3].x, x[3].y, x[3].z, x[3].w, x[4].x, x[4].y);
    Ray ray = getRay(cam, x[4].zw, x[5].xyz);
    y[0] = vec4(ray.o, ray.time);
    y[1].xyz = ray.d;
    y[2].xyz = cam.u;
    y[3].xyz = cam.v;
    y[4].xyz = cam.n;
}

#include "probe.glsl"

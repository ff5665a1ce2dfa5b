// A room through the shader's own camera and accumulation.
#include "rooms.glsl"
#include "../../shadertoy/common.glsl"
#include "rooms.glsl"
#undef SHADER_TOY
#include "../../shadertoy/P3D_RT.glsl"

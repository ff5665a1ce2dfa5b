// Which scene to show. For local tools only: shadertoy.com gets the scene's own file.
#ifndef SCENE
#define SCENE 0
#endif

#if SCENE == 0
#include "weekend.glsl"
#elif SCENE == 1
#include "fuzzy_refraction.glsl"
#elif SCENE == 2
#include "metal_roughness.glsl"
#elif SCENE == 3
#include "plastic.glsl"
#elif SCENE == 4
#include "cornell.glsl"
#else
#error SCENE is 0 (weekend), 1 (fuzzy refraction), 2 (metal), 3 (plastic) or 4 (Cornell box)
#endif

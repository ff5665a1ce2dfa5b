// Which scene to show. For local tools only: shadertoy.com gets the scene's own file.
#ifndef SCENE
#define SCENE 0
#endif

#if SCENE == 0
#include "weekend.glsl"
#else
#error SCENE is 0 (weekend)
#endif

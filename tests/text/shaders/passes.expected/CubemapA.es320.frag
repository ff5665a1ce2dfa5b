#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ;
layout(location = 0) out vec4 shadertoy_out_color;
uniform vec3 iResolution ;
uniform float iTime ;
uniform float iTimeDelta ;
uniform int iFrame ;
uniform vec4 iDate ;
uniform vec4 iMouse ;
uniform float iSampleRate ;
uniform float iFrameRate ;
uniform float iChannelTime [ 4 ] ;
uniform vec3 iChannelResolution [ 4 ] ;
uniform sampler2D iChannel0 ;
uniform sampler2D iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
uniform int shadertwin_face ; void mainCubemap ( out vec4 , in vec2 , in vec3 , in vec3 ) ;
void main ( ) { precise bool shadertwin_test; precise vec3 shadertwin_argument_0; precise vec2 st = 2.0 * gl_FragCoord . xy / iResolution . xy - 1.0 ; precise vec3 shadertwin_ray = shadertwin_face == 0 ? vec3 ( 1.0 , - st . y , - st . x ) : shadertwin_face == 1 ? vec3 ( - 1.0 , - st . y , st . x ) : shadertwin_face == 2 ? vec3 ( st . x , 1.0 , st . y ) : shadertwin_face == 3 ? vec3 ( st . x , - 1.0 , - st . y ) : shadertwin_face == 4 ? vec3 ( st . x , - st . y , 1.0 ) : vec3 ( - st . x , - st . y , - 1.0 ) ; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainCubemap ( shadertoy_color , gl_FragCoord . xy , vec3 ( 0.0 ) , (shadertwin_argument_0 = (normalize ( shadertwin_ray ))) ) ; shadertoy_out_color = vec4 ( unpackHalf2x16 ( packHalf2x16 ( shadertoy_color . rg ) ) , unpackHalf2x16 ( packHalf2x16 ( shadertoy_color . ba ) ) ) ; }


float wave ( precise float t , precise float hertz ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (sin ( uintBitsToFloat ( floatBitsToUint ( 6.2831853 * hertz * t ) ^ shadertwin_zero ) ))) ; }
void mainCubemap ( precise out vec4 c , precise in vec2 p , precise in vec3 origin , precise in vec3 direction ) { precise bool shadertwin_test; c = vec4 ( 0 ) ; c = vec4 ( direction , wave ( p . x , 1.0 ) ) ; }

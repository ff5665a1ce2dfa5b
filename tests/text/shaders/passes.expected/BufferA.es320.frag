#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ; int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } ivec2 shadertwin_safe_int ( precise vec2 a ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_int ( a . x ) , shadertwin_safe_int ( a . y ) ))) ; }
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
uniform samplerCube iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
void mainImage ( out vec4 , in vec2 ) ;
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }


float wave ( precise float t , precise float hertz ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (sin ( uintBitsToFloat ( floatBitsToUint ( 6.2831853 * hertz * t ) ^ shadertwin_zero ) ))) ; }


void mainImage ( precise out vec4 c , precise in vec2 p ) { precise bool shadertwin_test; c = vec4 ( 0 ) ;
c = texelFetch ( iChannel0 , ivec2 ( shadertwin_safe_int ( p ) ) , 0 ) + texture ( iChannel1 , vec3 ( p , 1.0 ) ) * wave ( iTime , 1.0 ) ;
}

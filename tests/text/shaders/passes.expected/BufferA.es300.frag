#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } ivec2 shadertwin_safe_int(vec2 a) { return ivec2(shadertwin_safe_int(a.x), shadertwin_safe_int(a.y)); }
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
void main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }


float wave ( float t , float hertz ) { return sin ( 6.2831853 * hertz * t ) ; }


void mainImage ( out vec4 c , in vec2 p ) { c = vec4(0);
c = texelFetch ( iChannel0 , ivec2 ( shadertwin_safe_int(p) ) , 0 ) + texture ( iChannel1 , vec3 ( p , 1.0 ) ) * wave ( iTime , 1.0 ) ;
}

#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; return b == 0 ? -1 : r; } int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } uint shadertwin_safe_uint(float x) { uint r = uint(x); return x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u; }
layout(local_size_x = 8, local_size_y = 8) in; layout(rgba32f, binding = 7) writeonly uniform highp image2D shadertwin_target; uniform ivec2 shadertwin_origin; vec4 shadertwin_frag_coord; vec4 shadertoy_out_color;
uniform vec3 iResolution ;
uniform float iTime ;
uniform float iTimeDelta ;
uniform int iFrame ;
uniform vec4 iDate ;
uniform vec4 iMouse ;
uniform float iSampleRate ;
uniform vec4 iMouseButton ;
uniform mat4 iViewMatrix ;
uniform vec3 iChannelResolution [ 10 ] ;
uniform sampler2D iChannel0 ;
uniform sampler2D iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
uniform sampler2D iChannel4 ;
uniform sampler2D iChannel5 ;
uniform sampler2D iChannel6 ;
uniform sampler2D iChannel7 ;
uniform sampler2D iChannel8 ;
uniform sampler2D iChannel9 ;
uniform sampler2D iKeyboard ;

float choose ( int k ) {
float r = 0.0 ;
switch ( k ) {
case 0 : return 1.0 ;
case 1 : r += 2.0 ;
case 2 : { float t = 3.0 ; r += t ; break ; }
default : r = - 1.0 ; break ;
case 4 : for ( int i = 0 ; i < 9 ; i ++ ) { if ( i == 3 ) break ; r += 4.0 ; } r += 0.5 ;
case 5 : { r *= 2.0 ; }
}
switch ( shadertwin_safe_modulo(k , 2) ) { case 0 : float z = 5.0 ; r += z ; break ; case 1 : z = 7.0 ; r -= z ; }
return r ;
}
float early ( float x ) { if ( x < 2.0 ) return x ; else if ( x < 4.0 ) { x *= 2.0 ; } else return - x ; for ( int i = 0 ; i < 3 ; i ++ ) if ( x > 5.0 ) return 9.0 ; return x ; }
void nothing ( int k ) { switch ( k ) { case 1 : { return ; } case 2 : { } default : break ; { ; } } }
int pick ( uint u ) { nothing ( int ( u ) ) ; switch ( u ) { case 3u : return 30 ; default : return 40 ; } return 0; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
color = vec4 ( choose ( int ( shadertwin_safe_int(p . x) ) ) , early ( p . x ) , float ( pick ( uint ( shadertwin_safe_uint(p . y) ) ) ) , early ( p . y ) ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

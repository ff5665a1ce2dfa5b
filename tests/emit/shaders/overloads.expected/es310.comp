#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } uint shadertwin_safe_uint(float x) { uint r = uint(x); return x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u; }
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



float f ( float x ) ; float f ( vec2 v ) ; float f ( int i ) ;
float g ( const in float x , int unused ) { return x + 1.0 ; }
float f ( uint u ) { return float ( u ) + 0.125 ; }
float f ( int i ) { return float ( i ) + 0.25 ; }
float f ( float x ) { return x + 0.5 ; }
float f ( vec2 v ) { return f ( v . x ) + f ( v . y ) ; }
float f ( vec2 v , float w ) { return f ( v ) * w ; }
float f ( mat2 m ) { return m [ 0 ] [ 0 ] ; }
float f ( float v [ 2 ] ) { return v [ 0 ] - v [ 1 ] ; }
bool f ( bool b ) { return ! b ; }
void nothing ( ) { }
vec4 zero ( ) { nothing ( ) ; return vec4 ( 0 ) ; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
color = zero ( ) + vec4 ( f ( p . x ) + f ( int ( shadertwin_safe_int(p . x) ) ) , f ( p , 2.0 ) , f ( uint ( shadertwin_safe_uint(p . y) ) ) + f ( mat2 ( p . x ) ) , g ( p . y , 3 ) + f ( float [ 2 ] ( p . x , p . y ) ) + ( f ( p . x > 3.0 ) ? 1.0 : 0.0 ) ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

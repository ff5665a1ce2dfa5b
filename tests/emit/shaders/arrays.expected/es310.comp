#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; return b == 0 ? -1 : r; } int shadertwin_at(int i, int last) { return clamp(i, 0, last); } int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }
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

const vec3 palette [ 4 ] = vec3 [ ] ( vec3 ( 0.1 , 0.2 , 0.3 ) , vec3 ( 1.0 ) , vec3 ( 0.5 , 0.25 , 0.125 ) , vec3 ( - 1.0 , 2.0 , 7.0 ) ) ;
const int steps [ 5 ] = int [ 5 ] ( 3 , 1 , 4 , 1 , 5 ) ;
const mat2 turns [ 2 ] = mat2 [ ] ( mat2 ( 0.0 , 1.0 , - 1.0 , 0.0 ) , mat2 ( 0.5 ) ) ;
float table [ 6 ] = float[6](0.0, 0.0, 0.0, 0.0, 0.0, 0.0) ;
float total ( float v [ 6 ] ) { v [ 0 ] = 100.0 ; float s = 0.0 ; for ( int i = 0 ; i < v . length ( ) ; i ++ ) s += v [ i ] ; return s ; }
float [ 2 ] both ( float a ) { return float [ ] ( a , a * a ) ; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
int k = shadertwin_safe_modulo(int ( shadertwin_safe_int(p . x) ) , 8) ;
for ( int i = 0 ; i < 6 ; ++ i ) table [ i ] = float ( i * i ) ;
const float weights [ ] = float [ ] ( 0.25 , 0.5 , 0.125 ) ;
float w = 0.0 ;
for ( int i = 0 ; i < weights . length ( ) ; i ++ ) w += weights [shadertwin_at( i , 2)] * float ( i + 1 ) ;
float local [ 3 ] = float[3](0.0, 0.0, 0.0) ;
local [shadertwin_at(( shadertwin_safe_modulo(k , 3) ), 2)] = 2.0 ;
float copy [ 3 ] = local ;
copy [ 0 ] += 1.0 ;
vec2 turned = turns [shadertwin_at(( k & 1 ), 1)] * vec2 ( 1.0 , 2.0 ) ;
color = vec4 ( palette [shadertwin_at(( clamp ( k , 0 , 3 ) ), 3)] [shadertwin_at(( shadertwin_safe_modulo(k , 3) ), 2)] , float ( steps [shadertwin_at(( shadertwin_safe_modulo(k , 5) ), 4)] ) + total ( table ) * 16.0 , w + both ( p . y ) [ 1 ] , turned . x ) ;
if ( p . y > 3.0 ) color = vec4 ( local [ 0 ] + local [ 1 ] , copy [ 0 ] , copy == local ? 1.0 : 0.0 , table [ 5 ] ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

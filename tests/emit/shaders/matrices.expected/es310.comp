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

mat3 rotation ( float a ) { float c = 0.5 + a , s = 0.25 ; return mat3 ( c , - s , 0.0 , s , c , 0.0 , 0.0 , 0.0 , 1.0 ) ; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
mat2 m = mat2 ( 1.0 , 2.0 , p . x , p . y ) ;
m *= 2.0 ; m += 1.0 ; m [ 1 ] -= vec2 ( 0.5 ) ; m [ 0 ] [ 1 ] = 4.0 ; m -= mat2 ( 1.0 ) ;
vec2 v = p ; v *= m ; v = m * v ;
mat3 r = rotation ( p . x / 8.0 ) ;
mat3 rr = r * r ; rr *= r ;
vec3 w = vec3 ( p , 1.0 ) ; w *= r ; w . xy *= m ;
mat2x3 n = mat2x3 ( p . x , 1.0 , 2.0 , p . y , 3.0 , 4.0 ) ;
mat3x2 nt = transpose ( n ) ;
vec3 nv = n * p ; vec2 vn = nv * n ; mat2 nn = nt * n ;
mat4 big = mat4 ( mat2 ( m ) ) ; big [ 3 ] = vec4 ( w , 1.0 ) ; mat3 small = mat3 ( big ) ; mat2 from = mat2 ( vec2 ( 1.0 , 2.0 ) , p ) ;
mat2 mixed = mat2 ( p . x , vec2 ( 1.0 , 2.0 ) , 3.0 ) , product = matrixCompMult ( m , from ) , outer = outerProduct ( p , vec2 ( 1.0 , 2.0 ) ) ;
mat2 quotient = m / 2.0 ; mat2 same = m ; same ++ ;
int i = shadertwin_safe_modulo(int ( shadertwin_safe_int(p . x) ) , 3) ;
float det = determinant ( mat2 ( 2.0 , 1.0 , p . x , 3.0 ) ) ;
mat2 inv = inverse ( mat2 ( 2.0 , 0.0 , 0.0 , 4.0 ) ) ;
color = vec4 ( v , w . x + w . y , rr [shadertwin_at( i , 2)] . x ) ;
if ( p . y > 2.0 ) color = vec4 ( nv . x , vn . y , nn [ 1 ] [ 0 ] , small [shadertwin_at( i , 2)] [ 2 ] ) ;
if ( p . y > 4.0 ) color = vec4 ( mixed [ 1 ] [ 0 ] , product [ 0 ] [ 1 ] , outer [ 1 ] . y , quotient [ 0 ] . x + ( m == same ? 1.0 : 0.0 ) ) ;
if ( p . y > 6.0 ) color = vec4 ( det , inv [ 1 ] [ 1 ] , - m [ 0 ] . x , ( - m + same ) [ 0 ] [ 0 ] ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

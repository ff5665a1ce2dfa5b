#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 float shadertwin_safe_over(float a, float b) { float r = a / b; bool zero = a == 0.0, infinite = b == 0.0, is_nan = zero && infinite || a != a || b != b; uint sign = (floatBitsToUint(a) ^ floatBitsToUint(b)) & 0x80000000u; return is_nan ? uintBitsToFloat(0x7fc00000u) : zero ? uintBitsToFloat(sign) : infinite ? uintBitsToFloat(sign | 0x7f800000u) : r; }
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



mat2 r ( float a ) { return mat2 ( 0.8 , - 0.6 , 0.6 , 0.8 ) * a ; }
void mainImage ( out vec4 O , vec2 U )
{ O = vec4(0);
vec2 u = ( U + U - iResolution . xy ) / iResolution . y , v = u * 0. ;
O *= 0. ; float i = 0. , d = 1. , z = 0. ; vec3 q = vec3(0) , p = vec3 ( 0 ) ;
for ( O = vec4 ( 0 ) ; i ++ < 9. ; O += shadertwin_safe_over(.1 , max ( d , .01 )) ) p = z * normalize ( vec3 ( u , 1 ) ) , p . z -= 2. , z += d = abs ( length ( p ) - 1. ) * .5 + .01 , q = p ;
for ( int k = 0 ; k < 3 ; k ++ , u *= r ( 1.1 ) , v += u ) ;
int n = 7 ; n = ( n & 1 ) == 1 ? n * 3 + 1 : n / 2 , n -= 2 ;
O . rg += v *= 0.25 ; ( O . b ) = float ( n ) + smoothstep ( 0.1 , 0.9 , u . x > 0. ? u . x : - u . x ) ;
O = abs ( O ) , O . a = 1. - ( U . x < 5. ? .5 : .25 ) , O = O . x > 3. ? O . yxzw : O ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

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

uint state = 0u ;
uint rnd ( ) { state = state * 747796405u + 2891336453u ; return state >> 9 ; }
float f ( ) { return float ( rnd ( ) & 255u ) ; }
float g ( float a , float b , float c ) { return a - b * 2.0 + c * 4.0 ; }
struct Pair { float a , b ; } ;
float pick ( int i ) { return i > 1 ? f ( ) : 1.0 ; }

vec4 late ( vec2 q ) {
float x = q . x , y = q . x , z = q . y ;
vec2 p = q , r = q ;
vec4 sum = vec4 ( p , p += 1.0 ) + vec4 ( x , x ++ , max ( y , y -= 1.0 ) , dot ( r , r += 1.0 ) ) ;
sum . x += p . x - length ( p -= 0.3 ) ;
r = r + ( r *= 2.0 ) ;
int i = int ( shadertwin_safe_int(q . x) ) ;
vec2 k = vec2 ( i , i ++ ) ;
sum . z += k . x * 3.0 + k . y ;
return sum + vec4 ( r , z , z = 9.0 ) ;
}
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
state = uint ( shadertwin_safe_uint(p . x) ) + 256u * uint ( shadertwin_safe_uint(p . y) ) ;
vec3 v = vec3 ( f ( ) , f ( ) , f ( ) ) ;
float a = f ( ) - f ( ) ;
float b = g ( f ( ) , f ( ) , f ( ) ) ;
Pair q = Pair ( f ( ) , f ( ) ) ;
float list [ 2 ] = float [ 2 ] ( f ( ) , f ( ) ) ;
int i = 0 ;
float c = float ( i ++ ) + float ( i ++ ) * 8.0 + float ( ++ i ) * 64.0 ;
float d = ( f ( ) > 100.0 && f ( ) > 50.0 || f ( ) < 9.0 ) ? f ( ) : - f ( ) ;
float e = pick ( i ) + ( f ( ) * 2.0 + ( f ( ) - f ( ) ) ) ;
for ( int k = int ( shadertwin_safe_int(f ( )) ) & 3 ; k < 5 && f ( ) < 250.0 ; k += 1 + int ( rnd ( ) & 1u ) ) e += float ( k ) ;
while ( f ( ) < 200.0 ) e += 0.5 ;
float x = 1.0 ;
float y = ( x += 1.0 , x * 3.0 ) ;
color = vec4 ( v . x + 256.0 * v . y , v . z + 0.5 * a , b + q . a - q . b * 0.5 , list [ 0 ] - list [ 1 ] + c ) ;
if ( mod ( p . x , 2.0 ) > 1.0 ) color = vec4 ( d , e , y , f ( ) ) ;
if ( p . y > 8.0 ) color = late ( p ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } uint shadertwin_safe_uint ( precise float x ) { precise bool shadertwin_test; precise uint shadertwin_result; precise uint r = uint ( x ) ; return (shadertwin_result = (x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u)) ; }
layout(location = 0) out vec4 shadertoy_out_color;
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

precise uint state = 0u ;
uint rnd ( ) { precise bool shadertwin_test; precise uint shadertwin_result; state = state * 747796405u + 2891336453u ; return (shadertwin_result = (state >> 9)) ; }
float f ( ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( rnd ( ) & 255u ))) ; }
float g ( precise float a , precise float b , precise float c ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (a - b * 2.0 + c * 4.0)) ; }
struct Pair { float a , b ; } ;
float pick ( precise int i ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (i > 1 ? f ( ) : 1.0)) ; }

vec4 late ( precise vec2 q ) { precise bool shadertwin_test; precise vec4 shadertwin_result;
precise float x = q . x , y = q . x , z = q . y ;
precise vec2 p = q , r = q ;
precise vec4 sum = vec4 ( p , p += 1.0 ) + vec4 ( x , x ++ , max ( y , y -= 1.0 ) , dot ( r , r += 1.0 ) ) ;
sum . x += p . x - length ( p -= 0.3 ) ;
r = r + ( r *= 2.0 ) ;
precise int i = int ( shadertwin_safe_int ( q . x ) ) ;
precise vec2 k = vec2 ( i , i ++ ) ;
sum . z += k . x * 3.0 + k . y ;
return (shadertwin_result = (sum + vec4 ( r , z , z = 9.0 ))) ;
}
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
state = uint ( shadertwin_safe_uint ( p . x ) ) + 256u * uint ( shadertwin_safe_uint ( p . y ) ) ;
precise vec3 v = vec3 ( f ( ) , f ( ) , f ( ) ) ;
precise float a = f ( ) - f ( ) ;
precise float b = g ( f ( ) , f ( ) , f ( ) ) ;
precise Pair q = Pair ( f ( ) , f ( ) ) ;
precise float list [ 2 ] = float [ 2 ] ( f ( ) , f ( ) ) ;
precise int i = 0 ;
precise float c = float ( i ++ ) + float ( i ++ ) * 8.0 + float ( ++ i ) * 64.0 ;
precise float d = ( f ( ) > 100.0 && f ( ) > 50.0 || f ( ) < 9.0 ) ? f ( ) : - f ( ) ;
precise float e = pick ( i ) + ( f ( ) * 2.0 + ( f ( ) - f ( ) ) ) ;
for ( precise int k = int ( shadertwin_safe_int ( f ( ) ) ) & 3 ; (shadertwin_test = (k < 5 && f ( ) < 250.0)) ; k += 1 + int ( rnd ( ) & 1u ) ) e += float ( k ) ;
while ( (shadertwin_test = (f ( ) < 200.0)) ) e += 0.5 ;
precise float x = 1.0 ;
precise float y = ( x += 1.0 , x * 3.0 ) ;
color = vec4 ( v . x + 256.0 * v . y , v . z + 0.5 * a , b + q . a - q . b * 0.5 , list [ 0 ] - list [ 1 ] + c ) ;
if ( (shadertwin_test = (mod ( p . x , 2.0 ) > 1.0)) ) color = vec4 ( d , e , y , f ( ) ) ;
if ( (shadertwin_test = (p . y > 8.0)) ) color = late ( p ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

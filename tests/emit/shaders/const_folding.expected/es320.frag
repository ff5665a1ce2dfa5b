#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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

const float a = 0.1 , b = 0.7 , c = a + b * 3.3 , d = sqrt ( 2.0 ) / 3.0 , e = 1.0 / 3.0 * 0.3 ;
const vec3 v = normalize ( vec3 ( 0.3 , 0.4 , 1.7 ) ) , w = cross ( v , vec3 ( 0.1 , 0.2 , 0.3 ) ) * 0.7 ;
const mat3 m = mat3 ( 0.00 , 0.80 , 0.60 , - 0.80 , 0.36 , - 0.48 , - 0.60 , - 0.48 , 0.64 ) ;
const mat3 mm = m * m ;
const int n = int ( 3.7 ) + 2 , list [ 3 ] = int [ ] ( n , n * 2 , n / 2 ) ;
const bool flag = n > 4 && a < b ;
const mat3 turned = transpose ( mat3 ( 1.0 , 2.0 , 3.0 , 4.0 , 5.0 , 6.0 , 7.0 , 8.0 , 10.0 ) ) , back = inverse ( mat3 ( 2.0 , 0.0 , 0.0 , 1.0 , 4.0 , 0.0 , 0.0 , 2.0 , 0.5 ) ) ;
const float size = determinant ( turned ) , infinite = uintBitsToFloat ( 0x7f800000u ) ;
const ivec2 bits = floatBitsToInt ( vec2 ( 2.0 , - 1.0 ) ) ;
const vec4 arcs = vec4 ( asin ( 0.3 ) , acos ( 0.3 ) , atan ( 0.3 ) , asin ( 1.0 ) ) , waves = vec4 ( sin ( 1.3 ) , cos ( 1.3 ) , tan ( 0.3 ) , acos ( - 1.0 ) ) ;
const vec4 hyperbolic = vec4 ( sinh ( 0.3 ) , cosh ( 0.3 ) , tanh ( 0.3 ) , asinh ( 0.3 ) ) , powers = vec4 ( exp ( 0.3 ) , log ( 0.3 ) , exp2 ( 0.3 ) , log2 ( 0.3 ) ) ;
const vec4 others = vec4 ( acosh ( 1.3 ) , atanh ( 0.3 ) , inversesqrt ( 0.3 ) , pow ( 0.3 , 0.7 ) ) , bent = vec4 ( reflect ( vec2 ( 0.3 , 0.4 ) , vec2 ( 0.6 , 0.8 ) ) , inverse ( mat2 ( 0.1 , 0.2 , 0.3 , 0.7 ) ) [ 0 ] ) ;
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
const float local = c * 0.9 - e , other = mix ( 0.1 , 0.9 , 0.35 ) ;
precise float sizes [ n ] ; for ( precise int shadertwin_i = 0 ; (shadertwin_test = (shadertwin_i < sizes . length ( ))) ; ++ shadertwin_i ) sizes [ shadertwin_i ] = 0.0 ;
sizes [ n - 1 ] = local ;
color = vec4 ( c , d , e , sizes [ 4 ] ) ;
if ( (shadertwin_test = (p . y > 3.0)) ) color = vec4 ( w , flag ? dot ( v , w ) : 0.0 ) ;
if ( (shadertwin_test = (p . y > 6.0)) ) color = vec4 ( ( m * v ) . x , mm [ 1 ] [ 2 ] , float ( list [ shadertwin_at ( ( shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 3 ) ) , 2 ) ] ) , other ) ;
if ( (shadertwin_test = (p . x > 4.0 && p . x < 11.0)) ) {
precise vec4 list [ 6 ] = vec4 [ 6 ] ( arcs , waves , hyperbolic , powers , others , bent + determinant ( mat2 ( 0.1 , 0.2 , 0.3 , 0.7 ) ) ) ;
color = list [ shadertwin_at ( ( shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 6 ) ) , 5 ) ] ;
}
if ( (shadertwin_test = (p . x > 12.0)) ) color = vec4 ( turned [ 2 ] . x + back [ 1 ] . y * p . x , size , p . x < infinite ? bits : - bits ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

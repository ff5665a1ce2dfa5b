#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_safe_divide ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a / d ; return (shadertwin_result = (b == 0 ? - 1 : b == - 1 ? - a : r)) ; } ivec2 shadertwin_safe_divide ( precise ivec2 a , precise ivec2 b ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_divide ( a . x , b . x ) , shadertwin_safe_divide ( a . y , b . y ) ))) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } ivec2 shadertwin_safe_modulo ( precise ivec2 a , precise int b ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_modulo ( a . x , b ) , shadertwin_safe_modulo ( a . y , b ) ))) ; } ivec2 shadertwin_safe_modulo_to ( precise inout ivec2 a , precise int b ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (a = shadertwin_safe_modulo ( a , b ))) ; } ivec2 shadertwin_safe_int ( precise vec2 a ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_int ( a . x ) , shadertwin_safe_int ( a . y ) ))) ; }
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

void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise vec2 shadertwin_argument_0; color = vec4 ( 0 ) ;
precise int x = int ( shadertwin_safe_int ( p . x ) ) - 8 , y = int ( shadertwin_safe_int ( p . y ) ) ;
precise uint u = uint ( int ( shadertwin_safe_int ( p . x ) ) ) * 2654435769u + uint ( y ) * 0x9E3779B9u ;
u ^= u >> 16 ; u *= 0x85ebca6bu ; u ^= u >> 13 ; u += 1U << 31 ;
precise int wrapped = 2147483647 + x + 8 ;
precise int product = 65537 * ( y + 65536 ) ;
precise ivec3 v = ivec3 ( x , y , 7 ) * 3 - ivec3 ( 1 ) ;
v . zx = abs ( v . zx ) ;
v ^= ivec3 ( 5 ) ; v |= 8 ; v &= ~ 2 ;
precise ivec2 d = shadertwin_safe_divide ( ivec2 ( 17 , - 17 ) , ivec2 ( y + 1 , 3 ) ) ;
precise int m = shadertwin_safe_modulo ( ( y + 20 ) , 7 ) ;
precise uvec2 q = uvec2 ( u ) >> uvec2 ( 3u , 5u ) ;
q <<= 2u ;
q . yx ^= q ; q . yx |= 1u ; q . yx &= q * 3u ; q . yx <<= 1u ; q . yx >>= uvec2 ( 1u , 2u ) ; shadertwin_safe_modulo_to ( v . zx , 11 ) ; v . xz /= 2 ;
x <<= 1 ; x >>= 2 ; x ++ ; -- x ;
precise bool odd = ( y & 1 ) == 1 ^^ x > 0 ;
precise ivec2 rounded = ivec2 ( shadertwin_safe_int ( (shadertwin_argument_0 = (vec2 ( p . x - 8.0 , p . y ) * 1.75)) ) ) ;
color = vec4 ( float ( u >> 8 ) , float ( wrapped / 1000 ) , float ( product ) , float ( v . x + v . y * 16 + v . z * 256 ) ) ;
if ( (shadertwin_test = (mod ( p . x , 2.0 ) > 1.0)) )
color = vec4 ( float ( d . x - d . y ) , float ( m ) , float ( q . x ^ q . y ) , float ( rounded . x * 10 + rounded . y ) + ( odd ? 0.5 : 0.0 ) ) ;
if ( (shadertwin_test = (mod ( p . y , 4.0 ) > 3.0)) ) color = vec4 ( uintBitsToFloat ( ( u >> 9 ) | 0x3f800000u ) , float ( x ) , float ( int ( u ) ) , float ( uint ( x ) ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

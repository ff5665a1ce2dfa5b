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

mat3 rotation ( precise float a ) { precise bool shadertwin_test; precise mat3 shadertwin_result; precise float c = 0.5 + a , s = 0.25 ; return (shadertwin_result = (mat3 ( c , - s , 0.0 , s , c , 0.0 , 0.0 , 0.0 , 1.0 ))) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise float shadertwin_argument_0; color = vec4 ( 0 ) ;
precise mat2 m = mat2 ( 1.0 , 2.0 , p . x , p . y ) ;
m *= 2.0 ; m += 1.0 ; m [ 1 ] -= vec2 ( 0.5 ) ; m [ 0 ] [ 1 ] = 4.0 ; m -= mat2 ( 1.0 ) ;
precise vec2 v = p ; v *= m ; v = m * v ;
precise mat3 r = rotation ( (shadertwin_argument_0 = (p . x / 8.0)) ) ;
precise mat3 rr = r * r ; rr *= r ;
precise vec3 w = vec3 ( p , 1.0 ) ; w *= r ; w . xy *= m ;
precise mat2x3 n = mat2x3 ( p . x , 1.0 , 2.0 , p . y , 3.0 , 4.0 ) ;
precise mat3x2 nt = transpose ( n ) ;
precise vec3 nv = n * p ; precise vec2 vn = nv * n ; precise mat2 nn = nt * n ;
precise mat4 big = mat4 ( mat2 ( m ) ) ; big [ 3 ] = vec4 ( w , 1.0 ) ; precise mat3 small = mat3 ( big ) ; precise mat2 from = mat2 ( vec2 ( 1.0 , 2.0 ) , p ) ;
precise mat2 mixed = mat2 ( p . x , vec2 ( 1.0 , 2.0 ) , 3.0 ) , product = matrixCompMult ( m , from ) , outer = outerProduct ( p , vec2 ( 1.0 , 2.0 ) ) ;
precise mat2 quotient = m / 2.0 ; precise mat2 same = m ; same ++ ;
precise int i = shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 3 ) ;
precise float det = determinant ( mat2 ( 2.0 , 1.0 , p . x , 3.0 ) ) ;
precise mat2 inv = inverse ( mat2 ( 2.0 , 0.0 , 0.0 , 4.0 ) ) ;
color = vec4 ( v , w . x + w . y , rr [ shadertwin_at ( i , 2 ) ] . x ) ;
if ( (shadertwin_test = (p . y > 2.0)) ) color = vec4 ( nv . x , vn . y , nn [ 1 ] [ 0 ] , small [ shadertwin_at ( i , 2 ) ] [ 2 ] ) ;
if ( (shadertwin_test = (p . y > 4.0)) ) color = vec4 ( mixed [ 1 ] [ 0 ] , product [ 0 ] [ 1 ] , outer [ 1 ] . y , quotient [ 0 ] . x + ( m == same ? 1.0 : 0.0 ) ) ;
if ( (shadertwin_test = (p . y > 6.0)) ) color = vec4 ( det , inv [ 1 ] [ 1 ] , - m [ 0 ] . x , ( - m + same ) [ 0 ] [ 0 ] ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

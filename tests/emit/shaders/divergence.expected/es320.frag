#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } ivec2 shadertwin_safe_int ( precise vec2 a ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_int ( a . x ) , shadertwin_safe_int ( a . y ) ))) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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


struct Item { vec2 at ; int tag ; bool on ; } ;
struct Bag { Item items [ 3 ] ; mat2 turn ; } ;
precise int steps = 0 ;
const Item first [ 2 ] = Item [ 2 ] ( Item ( vec2 ( 1 , 2 ) , 3 , true ) , Item ( vec2 ( 4 , 5 ) , 6 , false ) ) ;
const bool odd [ 3 ] = bool [ 3 ] ( false , true , true ) ;
const float grid [ 6 ] = float [ 6 ] ( 0.5 , 1.5 , 2.5 , 3.5 , 4.5 , 5.5 ) ;
int early ( precise int n ) { precise bool shadertwin_test; precise int shadertwin_result;
for ( precise int i = 0 ; (shadertwin_test = (i < 20)) ; i ++ ) {
if ( (shadertwin_test = (i * i > n)) ) return (shadertwin_result = (i)) ;
for ( precise int j = 0 ; ; j ++ ) {
if ( (shadertwin_test = (j > i)) ) break ;
if ( (shadertwin_test = (shadertwin_safe_modulo ( ( j + n ) , 5 ) == 4)) ) return (shadertwin_result = (100 + j)) ;
steps ++ ;
}
}
return (shadertwin_result = (- 1)) ;
}
bool count ( precise inout int n ) { precise bool shadertwin_test; precise bool shadertwin_result; n ++ ; steps += 2 ; return (shadertwin_result = (( n & 1 ) == 0)) ; }
int route ( precise int n ) { precise bool shadertwin_test; precise int shadertwin_result;
precise int sum = 0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < 7)) ; i ++ ) {
switch ( shadertwin_safe_modulo ( ( n + i ) , 6 ) ) {
case 0 : sum += 1 ;
case 1 : sum += 10 ; break ;
case 2 : if ( (shadertwin_test = (n > 9)) ) continue ; sum += 100 ; break ;
case 5 : if ( (shadertwin_test = (n == 3)) ) return (shadertwin_result = (sum + 100000)) ;
default : sum += 1000 ;
}
sum += i ;
if ( (shadertwin_test = (sum > 4000 + n)) ) break ;
}
return (shadertwin_result = (sum)) ;
}
float walk ( precise vec2 p , precise out int rounds ) { precise bool shadertwin_test; precise float shadertwin_result; rounds = 0 ;
precise float x = p . x ;
rounds = 0 ;
do {
rounds ++ ;
if ( (shadertwin_test = (mod ( float ( rounds ) + p . y , 3.0 ) < 1.0)) ) continue ;
x *= 0.75 ;
if ( (shadertwin_test = (x < 0.4)) ) return (shadertwin_result = (- x)) ;
} while ( (shadertwin_test = (rounds < 9 && ( x > 1.0 || count ( steps ) ))) ) ;
while ( (shadertwin_test = (true)) ) { if ( (shadertwin_test = (x > 8.0 + p . y)) ) break ; x = x * 1.5 + 1.0 ; if ( (shadertwin_test = (rounds > 6)) ) { x = - 3.0 ; break ; } }
return (shadertwin_result = (x)) ;
}
void put ( precise inout Bag bag , precise int i , precise int j ) { precise bool shadertwin_test;
bag . items [ shadertwin_at ( i , 2 ) ] . at [ shadertwin_at ( j , 1 ) ] += 2.0 ;
bag . items [ shadertwin_at ( i , 2 ) ] . tag = i * 3 + j ;
bag . items [ shadertwin_at ( ( shadertwin_safe_modulo ( ( i + 1 ) , 3 ) ) , 2 ) ] . on = odd [ shadertwin_at ( ( shadertwin_safe_modulo ( i , 3 ) ) , 2 ) ] ;
bag . turn [ shadertwin_at ( j , 1 ) ] [ shadertwin_at ( ( i & 1 ) , 1 ) ] -= 0.25 ;
if ( (shadertwin_test = (i == 1)) ) { bag . items [ shadertwin_at ( j , 2 ) ] . at . yx = vec2 ( float ( j ) , grid [ shadertwin_at ( ( i + 4 * j ) , 5 ) ] ) ; return ; }
bag . turn [ shadertwin_at ( ( i & 1 ) , 1 ) ] . xy *= 2.0 ;
}
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise vec2 shadertwin_argument_0; color = vec4 ( 0 ) ;
precise ivec2 q = ivec2 ( shadertwin_safe_int ( p ) ) ;
precise int n = q . x * 3 + q . y ;
precise int a = early ( n ) , b = route ( shadertwin_safe_modulo ( n , 13 ) ) , r = shadertwin_safe_modulo ( n , 4 ) , c = 0 ;
precise float w = walk ( (shadertwin_argument_0 = (p * 0.5)) , r ) ;
precise Bag bag = Bag ( Item [ 3 ] ( first [ 0 ] , first [ 1 ] , first [ shadertwin_at ( ( n & 1 ) , 1 ) ] ) , mat2 ( 1 , 0 , 0 , 1 ) ) ;
put ( bag , shadertwin_safe_modulo ( n , 3 ) , shadertwin_safe_modulo ( ( n / 2 ) , 2 ) ) ;
if ( (shadertwin_test = (shadertwin_safe_modulo ( n , 7 ) > 2 && count ( c ) || shadertwin_safe_modulo ( n , 5 ) == 1 && ! count ( c ))) ) c += 10 ; else if ( (shadertwin_test = (shadertwin_safe_modulo ( n , 2 ) == 0)) ) c -= 5 ;
c += shadertwin_safe_modulo ( n , 3 ) == 0 ? ( count ( c ) , c * 2 ) : shadertwin_safe_modulo ( n , 3 ) == 1 ? int ( shadertwin_safe_int ( grid [ shadertwin_at ( ( shadertwin_safe_modulo ( n , 9 ) - 1 ) , 5 ) ] ) ) : - c ;
precise vec4 v = vec4 ( p , 1 , 2 ) ;
v [ shadertwin_at ( ( shadertwin_safe_modulo ( n , 6 ) - 1 ) , 3 ) ] = 7.0 ;
precise int more [ 2 ] = int [ 2 ] ( 0 , 0 ) ;
more [ 0 ] = 5 ; more [ 1 ] = n ;
more [ shadertwin_at ( ( n & 1 ) , 1 ) ] ++ ;
precise int i = 0 ;
for ( ; (shadertwin_test = (i < 9)) ; i ++ ) { if ( (shadertwin_test = (i == shadertwin_safe_modulo ( n , 11 ))) ) break ; if ( (shadertwin_test = (shadertwin_safe_modulo ( i , 2 ) == 0)) ) continue ; more [ shadertwin_at ( ( i & 1 ) , 1 ) ] += i ; }
if ( (shadertwin_test = (shadertwin_safe_modulo ( n , 8 ) < 6)) ) { if ( (shadertwin_test = (first [ shadertwin_at ( ( shadertwin_safe_modulo ( n , 3 ) ) , 1 ) ] == first [ 1 ])) ) c += 1000 ; if ( (shadertwin_test = (bag . items [ 0 ] != first [ 0 ])) ) c += 2000 ; }
precise Item some = bag . items [ shadertwin_at ( ( shadertwin_safe_modulo ( ( n + 1 ) , 3 ) ) , 2 ) ] ;
color = vec4 ( a + b , w + float ( r ) , dot ( some . at , bag . turn * v . xy ) + float ( some . tag ) + v . z * v . w ,
c + i * 10 + more [ 0 ] * 100 + more [ 1 ] + steps + ( some . on ? 5000 : 0 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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


float f ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (x * 0.5)) ; }
float f ( precise int x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( x ) + 10.0)) ; }
float map ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (1.0 - 0.05 * x)) ; }
void two ( precise out float a , precise out float b ) { precise bool shadertwin_test; a = 0.0 ; b = 0.0 ; a = 3.0 ; b = 4.0 ; }
void set ( precise out vec2 a ) { precise bool shadertwin_test; a = vec2 ( 0 ) ; a = vec2 ( 7.0 , 8.0 ) ; }
precise vec2 shared_ [ 2 ] = vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ;
float touch ( precise int i ) { precise bool shadertwin_test; precise float shadertwin_result; shared_ [ shadertwin_at ( i , 1 ) ] . y = 5.0 ; return (shadertwin_result = (1.0)) ; }
float gone ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; if ( (shadertwin_test = (x > 14.0)) ) discard ; return (shadertwin_result = (1.0)) ; }
precise int total = 0 ;
int grow ( ) { precise bool shadertwin_test; precise int shadertwin_result; total += 3 ; return (shadertwin_result = (total)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise float shadertwin_argument_0; color = vec4 ( 0 ) ;
precise int k = int ( shadertwin_safe_int ( p . x ) ) & 1 ;
precise float n = 0.0 , d = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i ++ < 10 && ( d = map ( (shadertwin_argument_0 = (p . x + float ( i ))) ) ) > 0.5)) ; ) n += 1.0 ;
precise int m = 0 ;
precise bool b = ( m ++ < 2 ) || ( m += 4 ) > 0 ;
precise vec2 e [ 2 ] = vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ;
e [ 0 ] = e [ 1 ] = vec2 ( 0.0 ) ;
two ( e [ shadertwin_at ( k , 1 ) ] . x , e [ shadertwin_at ( k , 1 ) ] . y ) ;
shared_ [ 0 ] = shared_ [ 1 ] = vec2 ( 0.0 ) ;
shared_ [ shadertwin_at ( k , 1 ) ] . x = touch ( k ) ;
shared_ [ shadertwin_at ( k , 1 ) ] . x += touch ( 1 - k ) ;
precise vec2 a [ 3 ] = vec2 [ 3 ] ( vec2 ( 0 ) , vec2 ( 0 ) , vec2 ( 0 ) ) ;
a [ 0 ] = a [ 1 ] = a [ 2 ] = vec2 ( 0.0 ) ;
precise int j = 0 ;
set ( a [ shadertwin_at ( ( j ++ ) , 2 ) ] . xy ) ;
a [ shadertwin_at ( ( j ++ ) , 2 ) ] . x ++ ;
precise float grid [ 3 ] = float [ 3 ] ( 0.0 , 0.0 , 0.0 ) ;
grid [ 0 ] = grid [ 1 ] = grid [ 2 ] = p . x ;
precise int h = 0 ;
grid [ shadertwin_at ( ( h ++ ) , 2 ) ] ++ ;
grid [ shadertwin_at ( ( h ++ ) , 2 ) ] += 2.0 ;
precise vec2 c [ 2 ] = vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ;
c [ 0 ] = c [ 1 ] = p ;
precise int s = 0 ;
c [ shadertwin_at ( k , 1 ) ] [ shadertwin_at ( ( s ++ ) , 1 ) ] += 1.0 ;
precise int i = 0 ;
precise float r = float ( i ++ ) < p . x - 4.0 ? float ( i ) : 9.0 ;
total += grow ( ) ;
precise float sum = 0.0 ;
while ( (shadertwin_test = (sum < 3.0)) ) sum += gone ( p . x ) ;
color = vec4 ( n + float ( m ) * 16.0 + ( b ? 100.0 : 0.0 ) + f ( p . x ) + f ( 0.5 ) + f ( 1 ) * 1000.0 ,
e [ shadertwin_at ( k , 1 ) ] . x + 10.0 * e [ shadertwin_at ( k , 1 ) ] . y + a [ 0 ] . x + a [ 0 ] . y * 3.0 + a [ 1 ] . x * 100.0 + float ( j ) * 1000.0 ,
shared_ [ 0 ] . x + shared_ [ 0 ] . y * 2.0 + shared_ [ 1 ] . x * 4.0 + shared_ [ 1 ] . y * 8.0 + float ( total ) * 100.0 ,
grid [ 0 ] + grid [ 1 ] * 3.0 + float ( h ) * 100.0 + c [ shadertwin_at ( k , 1 ) ] . x * 7.0 + float ( s ) * 1000.0 + r * 0.5 + sum ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

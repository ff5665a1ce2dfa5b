#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; }
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

void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise float a = 0.0 , b = 0.0 , prev = 0.0 ;
for ( precise int i = 0 , j = 10 ; (shadertwin_test = (i < j)) ; i ++ , j -- ) { if ( (shadertwin_test = (i == 2)) ) continue ; a += float ( i * j ) ; }
precise int k = shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 5 ) ;
while ( (shadertwin_test = (true)) ) { if ( (shadertwin_test = (k ++ > 8)) ) break ; b += 1.0 ; }
do { b += 0.25 ; k -= 2 ; } while ( (shadertwin_test = (k > 0)) ) ;
for ( ; ; ) { if ( (shadertwin_test = (b > 30.0)) ) break ; b *= 2.0 ; }
precise float sum = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < 4)) ; i ++ ) { precise float cur = float ( i ) + p . y ; if ( (shadertwin_test = (i > 0)) ) sum += cur * prev ; prev = cur ; }
precise float fresh = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < 4)) ; i ++ ) { precise float once = 1.0 ; once += float ( i ) ; fresh += once ; { precise float once = 2.0 ; fresh *= once ; } }
for ( precise float t = 0.0 ; (shadertwin_test = (t < 1.0)) ; t += 0.125 ) for ( precise int i = 0 ; (shadertwin_test = (i < 2)) ; i ++ ) fresh += t ;
precise int n = 0 , i = 3 ;
for ( i = 0 ; (shadertwin_test = (i < 6)) ; ++ i ) if ( (shadertwin_test = (shadertwin_safe_modulo ( i , 2 ) == 0)) ) n += i ; else n -= 1 ;
for ( precise int q = 7 ; (shadertwin_test = (q > 0)) ; q >>= 1 ) ;
for ( ; (shadertwin_test = (n < 20)) ; n += 7 ) { precise int i = 4 ; a += float ( i ) ; }
precise float later = 0.0 ;
if ( (shadertwin_test = (p . x > 3.0)) ) later = 2.0 ; else { later = 3.0 ; }
color = vec4 ( a , b , sum , fresh + float ( n ) + float ( i ) + later ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

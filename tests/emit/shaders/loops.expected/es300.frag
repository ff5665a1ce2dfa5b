#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; return b == 0 ? -1 : r; }
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

void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
float a = 0.0 , b = 0.0 , prev = 0.0 ;
for ( int i = 0 , j = 10 ; i < j ; i ++ , j -- ) { if ( i == 2 ) continue ; a += float ( i * j ) ; }
int k = shadertwin_safe_modulo(int ( shadertwin_safe_int(p . x) ) , 5) ;
while ( true ) { if ( k ++ > 8 ) break ; b += 1.0 ; }
do { b += 0.25 ; k -= 2 ; } while ( k > 0 ) ;
for ( ; ; ) { if ( b > 30.0 ) break ; b *= 2.0 ; }
float sum = 0.0 ;
for ( int i = 0 ; i < 4 ; i ++ ) { float cur = float ( i ) + p . y ; if ( i > 0 ) sum += cur * prev ; prev = cur ; }
float fresh = 0.0 ;
for ( int i = 0 ; i < 4 ; i ++ ) { float once = 1.0 ; once += float ( i ) ; fresh += once ; { float once = 2.0 ; fresh *= once ; } }
for ( float t = 0.0 ; t < 1.0 ; t += 0.125 ) for ( int i = 0 ; i < 2 ; i ++ ) fresh += t ;
int n = 0 , i = 3 ;
for ( i = 0 ; i < 6 ; ++ i ) if ( shadertwin_safe_modulo(i , 2) == 0 ) n += i ; else n -= 1 ;
for ( int q = 7 ; q > 0 ; q >>= 1 ) ;
for ( ; n < 20 ; n += 7 ) { int i = 4 ; a += float ( i ) ; }
float later = 0.0 ;
if ( p . x > 3.0 ) later = 2.0 ; else { later = 3.0 ; }
color = vec4 ( a , b , sum , fresh + float ( n ) + float ( i ) + later ) ;
}
void main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

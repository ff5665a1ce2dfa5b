#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uint shadertwin_safe_uint ( precise float x ) { precise bool shadertwin_test; precise uint shadertwin_result; precise uint r = uint ( x ) ; return (shadertwin_result = (x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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

precise int k = 0 ;
int next ( ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (k ++)) ; }
float take ( precise inout float list [ 4 ] , precise int i ) { precise bool shadertwin_test; precise float shadertwin_result; list [ shadertwin_at ( i , 3 ) ] += 1.0 ; return (shadertwin_result = (list [ shadertwin_at ( i , 3 ) ])) ; }
float both ( precise inout float a , precise inout float b ) { precise bool shadertwin_test; precise float shadertwin_result; precise float t = a ; a = b ; b = t ; return (shadertwin_result = (a - b)) ; }
vec3 sample_ ( precise inout uint s ) { precise bool shadertwin_test; precise vec3 shadertwin_result; s = s * 1664525u + 1013904223u ; return (shadertwin_result = (vec3 ( s >> 8 , s >> 16 , s >> 24 ) / 256.0)) ; }
bool more ( precise inout int n ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (-- n > 0)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise float list [ 4 ] = float [ 4 ] ( p . x , 1.0 , 2.0 , 3.0 ) ;
list [ shadertwin_at ( ( next ( ) ) , 3 ) ] += 5.0 ;
list [ shadertwin_at ( ( next ( ) ) , 3 ) ] = list [ shadertwin_at ( ( next ( ) ) , 3 ) ] * 2.0 ;
precise float t = take ( list , 3 ) * take ( list , 3 ) + take ( list , k & 3 ) ;
precise float u = both ( list [ 0 ] , list [ 1 ] ) ;
precise uint s = uint ( shadertwin_safe_uint ( p . x ) ) * 17u + uint ( shadertwin_safe_uint ( p . y ) ) ;
precise vec3 v = sample_ ( s ) + sample_ ( s ) * 2.0 - cross ( sample_ ( s ) , sample_ ( s ) ) ;
precise vec2 w = p ;
w [ shadertwin_at ( ( next ( ) & 1 ) , 1 ) ] *= 3.0 ;
precise int n = 5 ; precise float sum = 0.0 ;
while ( (shadertwin_test = (more ( n ))) ) sum += float ( n ) ;
do sum *= 1.5 ; while ( (shadertwin_test = (more ( n ) || next ( ) < 8)) ) ;
for ( precise int i = next ( ) ; (shadertwin_test = (more ( i ))) ; sum += float ( i ) , next ( ) ) if ( (shadertwin_test = (sum > 100.0)) ) break ;
precise mat2 m = mat2 ( 1.0 ) ; m [ shadertwin_at ( ( next ( ) & 1 ) , 1 ) ] += vec2 ( sum , k ) ;
color = vec4 ( t + list [ 0 ] * 0.5 , u + v . x , v . y + w . x + m [ 0 ] . y , sum + w . y * 0.125 + float ( k ) + m [ 1 ] . x ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

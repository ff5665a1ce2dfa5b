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

const vec3 palette [ 4 ] = vec3 [ ] ( vec3 ( 0.1 , 0.2 , 0.3 ) , vec3 ( 1.0 ) , vec3 ( 0.5 , 0.25 , 0.125 ) , vec3 ( - 1.0 , 2.0 , 7.0 ) ) ;
const int steps [ 5 ] = int [ 5 ] ( 3 , 1 , 4 , 1 , 5 ) ;
const mat2 turns [ 2 ] = mat2 [ ] ( mat2 ( 0.0 , 1.0 , - 1.0 , 0.0 ) , mat2 ( 0.5 ) ) ;
precise float table [ 6 ] = float [ 6 ] ( 0.0 , 0.0 , 0.0 , 0.0 , 0.0 , 0.0 ) ;
float total ( precise float v [ 6 ] ) { precise bool shadertwin_test; precise float shadertwin_result; v [ 0 ] = 100.0 ; precise float s = 0.0 ; for ( precise int i = 0 ; (shadertwin_test = (i < v . length ( ))) ; i ++ ) s += v [ i ] ; return (shadertwin_result = (s)) ; }
float [ 2 ] both ( precise float a ) { precise bool shadertwin_test; return float [ ] ( a , a * a ) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise int k = shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 8 ) ;
for ( precise int i = 0 ; (shadertwin_test = (i < 6)) ; ++ i ) table [ i ] = float ( i * i ) ;
const float weights [ ] = float [ ] ( 0.25 , 0.5 , 0.125 ) ;
precise float w = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < weights . length ( ))) ; i ++ ) w += weights [ shadertwin_at ( i , 2 ) ] * float ( i + 1 ) ;
precise float local [ 3 ] = float [ 3 ] ( 0.0 , 0.0 , 0.0 ) ;
local [ shadertwin_at ( ( shadertwin_safe_modulo ( k , 3 ) ) , 2 ) ] = 2.0 ;
precise float copy [ 3 ] = local ;
copy [ 0 ] += 1.0 ;
precise vec2 turned = turns [ shadertwin_at ( ( k & 1 ) , 1 ) ] * vec2 ( 1.0 , 2.0 ) ;
color = vec4 ( palette [ shadertwin_at ( ( clamp ( k , 0 , 3 ) ) , 3 ) ] [ shadertwin_at ( ( shadertwin_safe_modulo ( k , 3 ) ) , 2 ) ] , float ( steps [ shadertwin_at ( ( shadertwin_safe_modulo ( k , 5 ) ) , 4 ) ] ) + total ( table ) * 16.0 , w + both ( p . y ) [ 1 ] , turned . x ) ;
if ( (shadertwin_test = (p . y > 3.0)) ) color = vec4 ( local [ 0 ] + local [ 1 ] , copy [ 0 ] , copy == local ? 1.0 : 0.0 , table [ 5 ] ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

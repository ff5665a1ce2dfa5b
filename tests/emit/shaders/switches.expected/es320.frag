#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } uint shadertwin_safe_uint ( precise float x ) { precise bool shadertwin_test; precise uint shadertwin_result; precise uint r = uint ( x ) ; return (shadertwin_result = (x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u)) ; }
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

float choose ( precise int k ) { precise bool shadertwin_test; precise float shadertwin_result;
precise float r = 0.0 ;
switch ( k ) {
case 0 : return (shadertwin_result = (1.0)) ;
case 1 : r += 2.0 ;
case 2 : { precise float t = 3.0 ; r += t ; break ; }
default : r = - 1.0 ; break ;
case 4 : for ( precise int i = 0 ; (shadertwin_test = (i < 9)) ; i ++ ) { if ( (shadertwin_test = (i == 3)) ) break ; r += 4.0 ; } r += 0.5 ;
case 5 : { r *= 2.0 ; }
}
switch ( shadertwin_safe_modulo ( k , 2 ) ) { case 0 : precise float z = 5.0 ; r += z ; break ; case 1 : z = 7.0 ; r -= z ; }
return (shadertwin_result = (r)) ;
}
float early ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; if ( (shadertwin_test = (x < 2.0)) ) return (shadertwin_result = (x)) ; else if ( (shadertwin_test = (x < 4.0)) ) { x *= 2.0 ; } else return (shadertwin_result = (- x)) ; for ( precise int i = 0 ; (shadertwin_test = (i < 3)) ; i ++ ) if ( (shadertwin_test = (x > 5.0)) ) return (shadertwin_result = (9.0)) ; return (shadertwin_result = (x)) ; }
void nothing ( precise int k ) { precise bool shadertwin_test; switch ( k ) { case 1 : { return ; } case 2 : { } default : break ; { ; } } }
int pick ( precise uint u ) { precise bool shadertwin_test; precise int shadertwin_result; nothing ( int ( u ) ) ; switch ( u ) { case 3u : return (shadertwin_result = (30)) ; default : return (shadertwin_result = (40)) ; } return (shadertwin_result = (0)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
color = vec4 ( choose ( int ( shadertwin_safe_int ( p . x ) ) ) , early ( p . x ) , float ( pick ( uint ( shadertwin_safe_uint ( p . y ) ) ) ) , early ( p . y ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

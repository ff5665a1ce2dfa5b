#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } uint shadertwin_safe_uint ( precise float x ) { precise bool shadertwin_test; precise uint shadertwin_result; precise uint r = uint ( x ) ; return (shadertwin_result = (x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u)) ; }
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



float f ( precise float x ) ; float f ( precise vec2 v ) ; float f ( precise int i ) ;
float g ( precise const in float x , precise int unused ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (x + 1.0)) ; }
float f ( precise uint u ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( u ) + 0.125)) ; }
float f ( precise int i ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( i ) + 0.25)) ; }
float f ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (x + 0.5)) ; }
float f ( precise vec2 v ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (f ( v . x ) + f ( v . y ))) ; }
float f ( precise vec2 v , precise float w ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (f ( v ) * w)) ; }
float f ( precise mat2 m ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (m [ 0 ] [ 0 ])) ; }
float f ( precise float v [ 2 ] ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (v [ 0 ] - v [ 1 ])) ; }
bool f ( precise bool b ) { precise bool shadertwin_test; precise bool shadertwin_result; return (shadertwin_result = (! b)) ; }
void nothing ( ) { precise bool shadertwin_test; }
vec4 zero ( ) { precise bool shadertwin_test; precise vec4 shadertwin_result; nothing ( ) ; return (shadertwin_result = (vec4 ( 0 ))) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise mat2x2 shadertwin_argument_0; precise float shadertwin_argument_1[2]; precise bool shadertwin_argument_2; color = vec4 ( 0 ) ;
color = zero ( ) + vec4 ( f ( p . x ) + f ( int ( shadertwin_safe_int ( p . x ) ) ) , f ( p , 2.0 ) , f ( uint ( shadertwin_safe_uint ( p . y ) ) ) + f ( (shadertwin_argument_0 = (mat2 ( p . x ))) ) , g ( p . y , 3 ) + f ( (shadertwin_argument_1 = (float [ 2 ] ( p . x , p . y ))) ) + ( f ( (shadertwin_argument_2 = (p . x > 3.0)) ) ? 1.0 : 0.0 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

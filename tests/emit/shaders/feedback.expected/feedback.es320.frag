#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } ivec2 shadertwin_safe_int ( precise vec2 a ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_int ( a . x ) , shadertwin_safe_int ( a . y ) ))) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } ivec2 shadertwin_safe_modulo ( precise ivec2 a , precise int b ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_modulo ( a . x , b ) , shadertwin_safe_modulo ( a . y , b ) ))) ; }
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
precise vec4 before = texelFetch ( iChannel0 , ivec2 ( shadertwin_safe_int ( p ) ) , 0 ) , other = texelFetch ( iChannel1 , shadertwin_safe_modulo ( ivec2 ( shadertwin_safe_int ( p . yx ) ) , 8 ) , 0 ) ;
if ( (shadertwin_test = (iFrame == 1 && p . x < 3.0)) ) discard ;
color = before * 0.5 + other + float ( iFrame ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;

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

float check ( precise vec2 p ) { precise bool shadertwin_test; precise float shadertwin_result; if ( (shadertwin_test = (p . x > 10.0)) ) discard ; for ( precise int i = 0 ; ; i ++ ) { if ( (shadertwin_test = (float ( i ) > p . y)) ) break ; if ( (shadertwin_test = (i == 6)) ) discard ; } return (shadertwin_result = (p . x)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
if ( (shadertwin_test = (mod ( p . x , 4.0 ) < 1.0 && p . y < 4.0)) ) discard ;
color = vec4 ( check ( p ) , p . y , 1.0 , 1.0 ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

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

float grid ( precise vec2 p ) { precise bool shadertwin_test; precise float shadertwin_result; precise vec2 w = fwidth ( p ) ; return (shadertwin_result = (w . x + w . y)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise vec2 shadertwin_argument_0; color = vec4 ( 0 ) ;
precise float f = p . x * p . x + p . y * 3.0 ;
precise vec2 uv = p * vec2 ( 0.5 , 2.0 ) ;
if ( (shadertwin_test = (p . x > 5.0)) ) f += 10.0 ;
precise vec3 v = dFdx ( vec3 ( f , uv ) ) ;
color = vec4 ( v . x + v . z , dFdy ( f ) , grid ( (shadertwin_argument_0 = (uv * uv)) ) , fwidth ( f ) + dFdy ( uv ) . y ) ;
for ( precise int i = 0 ; (shadertwin_test = (i < 3)) ; i ++ ) { f *= 2.0 ; color . x += dFdx ( f ) ; }
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

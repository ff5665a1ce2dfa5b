#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ;
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
precise vec2 uv = p / iResolution . yx ;
precise float x = sqrt ( p . x / 7.0 ) - p . y / iResolution . x , y = p . y / iResolution . y ;
color = vec4 ( mix ( x , y , 0.3 ) , mix ( x , 1.0 , y ) , mix ( vec2 ( x , y ) , uv , 0.7 ) . y , mix ( uv , vec2 ( y , x ) , x ) . x ) ;
if ( (shadertwin_test = (p . y > 3.0)) ) color = vec4 ( pow ( uintBitsToFloat ( floatBitsToUint ( y ) ^ shadertwin_zero ) , 2.0 ) , pow ( uintBitsToFloat ( floatBitsToUint ( y + x ) ^ shadertwin_zero ) , 4.0 ) , pow ( 2.0 , uintBitsToFloat ( floatBitsToUint ( x ) ^ shadertwin_zero ) ) , pow ( uintBitsToFloat ( floatBitsToUint ( uv ) ^ shadertwin_zero ) , vec2 ( 2.0 ) ) . y ) ;
if ( (shadertwin_test = (p . y > 6.0)) ) color = vec4 ( min ( 0.0 , - x * 0.0 ) , max ( vec2 ( 0.5 ) , uv ) . x , pow ( uintBitsToFloat ( floatBitsToUint ( y ) ^ shadertwin_zero ) , 1.0 ) , pow ( uintBitsToFloat ( floatBitsToUint ( abs ( x ) ) ^ shadertwin_zero ) , 1.3 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

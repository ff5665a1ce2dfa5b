#version 300 es
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





















const float TAU = 2.0 * 3.14159265359 , THIRD = TAU / 3.0 ;


float time_scale = 2.0 ;
void mainImage ( out vec4 O , vec2 U ) { O = vec4(0);
float acc = 0.0 ;
for ( int i = 0 ; i < 4 ; i ++ ) { acc += ( ( float ( i ) ) * ( float ( i ) ) ) * 2.0 ; }
vec2 R = iResolution . xy , uv = ( U + U - R ) / R . y * mat2 ( 1.0 - ( 0.25 ) , - ( 0.25 ) , ( 0.25 ) , 1.0 - ( 0.25 ) ) ;
O = vec4 ( acc + 0.5 , uv , THIRD * time_scale + ( iTime + 0.25 ) ) ;
}
void main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

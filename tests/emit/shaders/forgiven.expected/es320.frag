#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; }
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






struct Segment { float shadertwin_length ; vec2 way ; } ;
precise float shadertwin_step = 0.25 , shadertwin_packed = 2.0 ;
const mat3 turned = transpose ( mat3 ( 1 , 2 , 3 , 4 , 5 , 6 , 7 , 8 , 9 ) ) ;
float shadertwin_mix ( precise float a , precise float b , precise float c ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } float shadertwin_mix ( precise float a , precise float b , precise bool c ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec2 shadertwin_mix ( precise vec2 a , precise vec2 b , precise vec2 c ) { precise bool shadertwin_test; precise vec2 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec2 shadertwin_mix ( precise vec2 a , precise vec2 b , precise float c ) { precise bool shadertwin_test; precise vec2 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec2 shadertwin_mix ( precise vec2 a , precise vec2 b , precise bvec2 c ) { precise bool shadertwin_test; precise vec2 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec3 shadertwin_mix ( precise vec3 a , precise vec3 b , precise vec3 c ) { precise bool shadertwin_test; precise vec3 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec3 shadertwin_mix ( precise vec3 a , precise vec3 b , precise float c ) { precise bool shadertwin_test; precise vec3 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec3 shadertwin_mix ( precise vec3 a , precise vec3 b , precise bvec3 c ) { precise bool shadertwin_test; precise vec3 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec4 shadertwin_mix ( precise vec4 a , precise vec4 b , precise vec4 c ) { precise bool shadertwin_test; precise vec4 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec4 shadertwin_mix ( precise vec4 a , precise vec4 b , precise float c ) { precise bool shadertwin_test; precise vec4 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec4 shadertwin_mix ( precise vec4 a , precise vec4 b , precise bvec4 c ) { precise bool shadertwin_test; precise vec4 shadertwin_result; return (shadertwin_result = (mix ( a , b , c ))) ; } vec2 shadertwin_mix ( precise vec2 a , precise vec2 b , precise vec3 c ) { precise bool shadertwin_test; precise vec2 shadertwin_result; return (shadertwin_result = (a * c . xy + b * c . z)) ; }
vec3 shadertwin_fma ( precise vec3 a , precise vec3 b , precise vec3 shadertwin_unnamed_0 ) { precise bool shadertwin_test; precise vec3 shadertwin_result; return (shadertwin_result = (a * b)) ; }
float choose ( precise int k )
{ precise bool shadertwin_test; precise float shadertwin_result;
switch ( k ) {
case 0 : return (shadertwin_result = (1.0)) ;
case 1 : break ; ;
}
return (shadertwin_result = (shadertwin_step)) ;
}
void mainImage ( precise out vec4 c , precise vec2 p )
{ precise bool shadertwin_test; precise vec3 shadertwin_argument_0; c = vec4 ( 0 ) ;
precise Segment s = Segment ( 2.0 , p ) ;
s . shadertwin_length *= 1.0 + - 1.0 + shadertwin_step ;
c = vec4 ( shadertwin_mix ( p , s . way , vec3 ( 1 , 2 , 3 ) ) , shadertwin_mix ( 1.0 , 2.0 , 0.5 ) * shadertwin_packed , choose ( int ( shadertwin_safe_int ( p . x ) ) ) + s . shadertwin_length ) ;
c . xyz += shadertwin_fma ( turned [ 1 ] , (shadertwin_argument_0 = (vec3 ( p , 1 ))) , vec3 ( 0 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

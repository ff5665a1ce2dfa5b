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

struct auto_t { float new_ ; float signed_ ; } ;
float class_ ( precise float a ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (a)) ; }
float delete ( precise float this_ ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (this_ + 1.0)) ; }
float int_ ( precise float and ) { precise bool shadertwin_test; precise float shadertwin_result; precise float or = and * 2.0 ; return (shadertwin_result = (or)) ; }
float fract_ ( precise float x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (x - floor ( x ))) ; }
float array ( precise float std ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (std * 3.0)) ; }
float swizzle ( precise float at ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (at - 1.0)) ; }
float _Complex ( precise float _Atomic ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (_Atomic)) ; }
precise float register_ = 0.0 ;
precise float M_PI = 3.0 , NULL = 4.0 , EOF = 5.0 , assert = 6.0 , errno = 7.0 , INFINITY = 2.0 ;
struct private_ { float operator_ ; vec2 friend_ ; } ;
float map ( precise vec3 p ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (p . x)) ; }
float noise ( precise float p ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (p * 0.5)) ; }
precise vec2 uv = vec2 ( 3.0 ) ;
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise float noise = noise ( _Complex ( p . x ) ) , length = length ( p * vec2 ( 0.0 , 1.0 ) ) , mix = mix ( 0.0 , 4.0 , 0.5 ) ;
precise float char = 1.0 , signed = 2.0 , new = 3.0 , nullptr = 4.0 , main_ = 5.0 , thread_local = 6.0 , xor = 7.0 , not_eq = 8.0 , wchar_t = 9.0 ;
precise float array_ = array ( p . y ) , Shader = 2.0 , vec = 3.0 , glm = 4.0 , tmp = 1.0 , make = 3.0 , divide = 2.0 , lane_ = 4.0 ;
precise vec2 uv = uv + p ;
{ precise vec2 uv = uv * 2.0 ; noise += uv . x ; precise float p = uv . y ; noise += p ; }
precise private_ s = private_ ( 1.0 , vec2 ( 2.0 , 3.0 ) ) ;
color = vec4 ( noise + length + mix , char + signed * new + nullptr + main_ + thread_local + xor + not_eq + wchar_t ,
array_ + Shader + vec + glm + tmp + make + divide + lane_ + swizzle ( delete ( int_ ( 1.0 ) ) ) ,
M_PI + NULL + EOF + assert + errno + INFINITY + s . friend_ . y + s . operator_ + uv . y + map ( vec3 ( 1.0 ) ) + class_ ( 2.0 ) + fract_ ( 1.25 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

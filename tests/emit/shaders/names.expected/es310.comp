#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;

layout(local_size_x = 8, local_size_y = 8) in; layout(rgba32f, binding = 7) writeonly uniform highp image2D shadertwin_target; uniform ivec2 shadertwin_origin; vec4 shadertwin_frag_coord; vec4 shadertoy_out_color;
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
float class_ ( float a ) { return a ; }
float delete ( float this_ ) { return this_ + 1.0 ; }
float int_ ( float and ) { float or = and * 2.0 ; return or ; }
float fract_ ( float x ) { return x - floor ( x ) ; }
float array ( float std ) { return std * 3.0 ; }
float swizzle ( float at ) { return at - 1.0 ; }
float _Complex ( float _Atomic ) { return _Atomic ; }
float register_ = 0.0 ;
float M_PI = 3.0 , NULL = 4.0 , EOF = 5.0 , assert = 6.0 , errno = 7.0 , INFINITY = 2.0 ;
struct private_ { float operator_ ; vec2 friend_ ; } ;
float map ( vec3 p ) { return p . x ; }
float noise ( float p ) { return p * 0.5 ; }
vec2 uv = vec2 ( 3.0 ) ;
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
float noise = noise ( _Complex ( p . x ) ) , length = length ( p * vec2 ( 0.0 , 1.0 ) ) , mix = mix ( 0.0 , 4.0 , 0.5 ) ;
float char = 1.0 , signed = 2.0 , new = 3.0 , nullptr = 4.0 , main_ = 5.0 , thread_local = 6.0 , xor = 7.0 , not_eq = 8.0 , wchar_t = 9.0 ;
float array_ = array ( p . y ) , Shader = 2.0 , vec = 3.0 , glm = 4.0 , tmp = 1.0 , make = 3.0 , divide = 2.0 , lane_ = 4.0 ;
vec2 uv = uv + p ;
{ vec2 uv = uv * 2.0 ; noise += uv . x ; float p = uv . y ; noise += p ; }
private_ s = private_ ( 1.0 , vec2 ( 2.0 , 3.0 ) ) ;
color = vec4 ( noise + length + mix , char + signed * new + nullptr + main_ + thread_local + xor + not_eq + wchar_t ,
array_ + Shader + vec + glm + tmp + make + divide + lane_ + swizzle ( delete ( int_ ( 1.0 ) ) ) ,
M_PI + NULL + EOF + assert + errno + INFINITY + s . friend_ . y + s . operator_ + uv . y + map ( vec3 ( 1.0 ) ) + class_ ( 2.0 ) + fract_ ( 1.25 ) ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

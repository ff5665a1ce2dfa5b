#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; return b == 0 ? -1 : r; } ivec3 shadertwin_safe_int(vec3 a) { return ivec3(shadertwin_safe_int(a.x), shadertwin_safe_int(a.y), shadertwin_safe_int(a.z)); } int shadertwin_at(int i, int last) { return clamp(i, 0, last); } int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }
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

void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
vec4 v = vec4 ( p , p . yx * 0.5 ) ;
v . wz = v . xy ;
v . rgb = v . bgr ;
v . st += vec2 ( 1.0 , 2.0 ) ;
v . xyz . zy *= 2.0 ;
v . zyxw . xy = v . xx ;
v . y ++ ; v . xz -- ; ++ v . w ;
vec3 a = v . xyz / 4.0 + 1.0 , b = 2.0 - a , c = - a * b ;
c -= 0.5 ; c /= vec3 ( 1.0 , 2.0 , 4.0 ) ; c *= 3.0 ;
bvec3 less = lessThan ( a , b ) , more = greaterThanEqual ( b , c ) ;
bool every = all ( not ( less ) ) , some = any ( more ) , same = a == b , other = a . xy != b . xy ;
int i = shadertwin_safe_modulo(int ( shadertwin_safe_int(p . x) ) , 3) ;
a [shadertwin_at( i , 2)] = 9.0 ; b [shadertwin_at(( 2 - i ), 2)] += 1.0 ;
vec2 t = p . x > 4.0 ? a . zy : b . xx ;
float s = vec3 ( 1.0 , 2.0 , 3.0 ) [shadertwin_at( i , 2)] ;
v . x = v . y = t . x ;
color = vec4 ( a . x + b . y + c . z , t . x - t . y , float ( every ) + 2.0 * float ( some ) + 4.0 * float ( same ) + 8.0 * float ( other ) , v . x + v . z + s ) ;
if ( p . y > 4.0 ) color = vec4 ( equal ( a , b ) . x ? 1 : 2 , notEqual ( ivec2 ( shadertwin_safe_int(a) ) , ivec2 ( shadertwin_safe_int(b) ) ) . y ? 3 : 4 , mix ( a , b , less ) . x , v . w ) ;
}
void main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

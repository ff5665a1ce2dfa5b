#version 300 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 uint shadertwin_safe_uint(float x) { uint r = uint(x); return x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u; } int shadertwin_at(int i, int last) { return clamp(i, 0, last); } int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }
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

int k = 0 ;
int next ( ) { return k ++ ; }
float take ( inout float list [ 4 ] , int i ) { list [shadertwin_at( i , 3)] += 1.0 ; return list [shadertwin_at( i , 3)] ; }
float both ( inout float a , inout float b ) { float t = a ; a = b ; b = t ; return a - b ; }
vec3 sample_ ( inout uint s ) { s = s * 1664525u + 1013904223u ; return vec3 ( s >> 8 , s >> 16 , s >> 24 ) / 256.0 ; }
bool more ( inout int n ) { return -- n > 0 ; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
float list [ 4 ] = float [ 4 ] ( p . x , 1.0 , 2.0 , 3.0 ) ;
list [shadertwin_at(( next ( ) ), 3)] += 5.0 ;
list [shadertwin_at(( next ( ) ), 3)] = list [shadertwin_at(( next ( ) ), 3)] * 2.0 ;
float t = take ( list , 3 ) * take ( list , 3 ) + take ( list , k & 3 ) ;
float u = both ( list [ 0 ] , list [ 1 ] ) ;
uint s = uint ( shadertwin_safe_uint(p . x) ) * 17u + uint ( shadertwin_safe_uint(p . y) ) ;
vec3 v = sample_ ( s ) + sample_ ( s ) * 2.0 - cross ( sample_ ( s ) , sample_ ( s ) ) ;
vec2 w = p ;
w [shadertwin_at(( next ( ) & 1 ), 1)] *= 3.0 ;
int n = 5 ; float sum = 0.0 ;
while ( more ( n ) ) sum += float ( n ) ;
do sum *= 1.5 ; while ( more ( n ) || next ( ) < 8 ) ;
for ( int i = next ( ) ; more ( i ) ; sum += float ( i ) , next ( ) ) if ( sum > 100.0 ) break ;
mat2 m = mat2 ( 1.0 ) ; m [shadertwin_at(( next ( ) & 1 ), 1)] += vec2 ( sum , k ) ;
color = vec4 ( t + list [ 0 ] * 0.5 , u + v . x , v . y + w . x + m [ 0 ] . y , sum + w . y * 0.125 + float ( k ) + m [ 1 ] . x ) ;
}
void main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_at(int i, int last) { return clamp(i, 0, last); } int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }
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

vec3 shared_value = vec3 ( 1.0 , 2.0 , 3.0 ) ;
float counter = 0.0 ;
void add ( inout float a , in float b , inout float c ) { a += b ; c = a * 2.0 ; }
void write ( out vec2 v , float x ) { v = vec2(0); v = vec2 ( x , - x ) ; }
float touch_global ( inout vec3 v ) { v . x = 10.0 ; counter += shared_value . x ; shared_value . y = 5.0 ; return shared_value . x + v . y ; }
float next ( inout float s ) { s += 0.25 ; return s ; }
void half_written ( out vec4 v , float x ) { v = vec4(0); if ( x > 0.5 ) v . xy = vec2 ( x ) ; v . z = 1.0 ; }
void mainImage ( out vec4 color , in vec2 p ) { color = vec4(0);
float x = p . x / 8.0 ;
vec4 v = vec4 ( x , 2.0 , 3.0 , 4.0 ) ;
write ( v . zx , x ) ;
float list [ 3 ] = float [ 3 ] ( x , 1.0 , 2.0 ) ;
int i = 1 ;
add ( list [shadertwin_at( i , 2)] , v . x , list [ 2 ] ) ;
add ( v . y , v . y , v . w ) ;
float r = touch_global ( shared_value ) ;
float s = x ;
vec2 pair = vec2 ( next ( s ) , next ( s ) ) ;
float sum = next ( s ) * 2.0 - next ( s ) + s ;
color = vec4 ( v . x + v . z * 4.0 , r + shared_value . x * 100.0 + shared_value . y , pair . x + pair . y * 16.0 , sum ) ;
if ( p . y < 2.0 ) color = v ;
if ( p . y > 6.0 ) color = vec4 ( list [ 0 ] , list [ 1 ] , list [ 2 ] , counter ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

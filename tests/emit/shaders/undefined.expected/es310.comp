#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } int shadertwin_at(int i, int last) { return clamp(i, 0, last); } int shadertwin_at(uint i, int last) { return int(min(i, uint(last))); }
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

struct Thing { float weight ; vec2 corners [ 2 ] ; } ;
float table [ 1000 ] ;
vec2 pairs [ 3 ] = vec2[3](vec2(0), vec2(0), vec2(0)) ;
Thing things [ 2 ] = Thing[2](Thing(0.0, vec2[2](vec2(0), vec2(0))), Thing(0.0, vec2[2](vec2(0), vec2(0)))) ;

void take ( out Thing thing , out float list [ 3 ] , out mat2 turn )
{ thing = Thing(0.0, vec2[2](vec2(0), vec2(0))); list = float[3](0.0, 0.0, 0.0); turn = mat2(0);
if ( iFrame > 100 )
thing . weight = 1.0 ;
}

vec3 missing ( float x )
{
if ( x > 9.0 )
return vec3 ( x ) ;
return vec3(0); }

Thing missing_thing ( float x )
{
if ( x > 9.0 ) {
Thing thing = Thing(0.0, vec2[2](vec2(0), vec2(0))) ;
thing . weight = 3.0 ;
return thing ;
}
return Thing(0.0, vec2[2](vec2(0), vec2(0))); }

float long_list ( int n )
{
float list [ 300 ] ; for (int shadertwin_i = 0; shadertwin_i < list.length(); ++shadertwin_i) list[shadertwin_i] = 0.0;
for ( int i = 0 ; i < n ; i ++ )
list [shadertwin_at( i , 299)] += 1.0 ;
float sum = 0.0 ;
for ( int i = 0 ; i < 300 ; i ++ )
sum += list [ i ] ;
return sum ;
}

int calls = 0 ;
int next ( ) { return calls ++ ; }

vec3 partly ( float x )
{
vec3 color = vec3(0) ;
if ( x < 2.0 )
color = vec3 ( 1.0 , 2.0 , 3.0 ) ;
else if ( x < 4.0 )
color = vec3 ( 4.0 ) ;
else
color . x = 0.5 ;
return color ;
}

float rounds ( float x )
{
float sum = 0.0 ;
for ( int k = 0 ; k < 3 ; k ++ ) {
float a = 1.0 , z = 0.0 ;
for ( ; z < 1.0 ; z += 0.25 )
a += fract ( x * z ) ;
sum += a ;
}
return sum ;
}

void mainImage ( out vec4 c , in vec2 p )
{ c = vec4(0);
table [shadertwin_at(( int ( shadertwin_safe_int(p . x) ) ), 999)] += 1.0 ;
float sum = 0.0 ;
for ( int i = 0 ; i < 1000 ; i ++ )
sum += table [ i ] ;
for ( float i = 0.0 , kept = 0.0 ; i < 3.0 ; i ++ ) {
float fresh = 0.0 ;
kept += i ;
fresh += kept ;
sum += kept + fresh ;
}

Thing thing = Thing(0.0, vec2[2](vec2(0), vec2(0))) ;
thing . weight = 5.0 ;
thing . corners [ 1 ] = p ;
float list [ 3 ] = float [ 3 ] ( 1.0 , 2.0 , 3.0 ) ;
mat2 turn = mat2 ( 3.0 ) ;
take ( thing , list , turn ) ;
float outs = thing . weight + thing . corners [ 1 ] . x + list [ 1 ] + turn [ 1 ] [ 1 ] ;

int far = int ( shadertwin_safe_int(p . x) ) * 9 - 40 ;
uint unsigned_far = uint ( far ) ;
float five [ 5 ] = float [ ] ( 1.0 , 2.0 , 3.0 , 4.0 , 5.0 ) ;
mat3 m = mat3 ( 1.0 , 2.0 , 3.0 , 4.0 , 5.0 , 6.0 , 7.0 , 8.0 , 9.0 ) ;
five [shadertwin_at( far , 4)] += 10.0 ;
five [shadertwin_at(( next ( ) ), 4)] += 100.0 ;
m [shadertwin_at( far , 2)] [shadertwin_at( unsigned_far , 2)] += 1000.0 ;
float indexed = five [ 0 ] + five [ 4 ] * 2.0 + m [ 0 ] [ 0 ] + m [ 2 ] [ 2 ] * 3.0 + vec3 ( 1 , 2 , 3 ) [shadertwin_at( far , 2)] + five [shadertwin_at( unsigned_far , 4)] +
float ( calls ) + pairs [shadertwin_at( far , 2)] . x + things [shadertwin_at( far , 1)] . weight ;

vec3 nowhere = missing ( p . x ) + missing_thing ( p . y ) . weight ;
c = vec4 ( sum + long_list ( 3 ) + long_list ( 4 ) , outs , indexed , nowhere . y + dot ( partly ( p . x ) , vec3 ( 1.0 , 10.0 , 100.0 ) ) + rounds ( p . y ) ) ;
}
void shadertwin_main ( ) { for (int shadertwin_i = 0; shadertwin_i < table.length(); ++shadertwin_i) table[shadertwin_i] = 0.0; vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

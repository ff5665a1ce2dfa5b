#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } ivec2 shadertwin_safe_int(vec2 a) { return ivec2(shadertwin_safe_int(a.x), shadertwin_safe_int(a.y)); }
layout(local_size_x = 8, local_size_y = 8) in; layout(rgba32f, binding = 7) writeonly uniform highp image2D shadertwin_target; uniform ivec2 shadertwin_origin; vec4 shadertwin_frag_coord; vec4 shadertoy_out_color;
uniform vec3 iResolution ;
uniform float iTime ;
uniform float iTimeDelta ;
uniform int iFrame ;
uniform vec4 iDate ;
uniform vec4 iMouse ;
uniform float iSampleRate ;
uniform float iFrameRate ;
uniform float iChannelTime [ 4 ] ;
uniform vec3 iChannelResolution [ 4 ] ;
uniform sampler2D iChannel0 ;
uniform samplerCube iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
void mainImage ( out vec4 , in vec2 ) ;
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }


float wave ( float t , float hertz ) { return sin ( 6.2831853 * hertz * t ) ; }


void mainImage ( out vec4 c , in vec2 p ) { c = vec4(0);
c = texelFetch ( iChannel0 , ivec2 ( shadertwin_safe_int(p) ) , 0 ) + texture ( iChannel1 , vec3 ( p , 1.0 ) ) * wave ( iTime , 1.0 ) ;
}
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

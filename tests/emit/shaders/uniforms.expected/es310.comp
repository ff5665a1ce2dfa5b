#version 310 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
 int shadertwin_safe_int(float x) { int r = int(x); return x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r; } int shadertwin_safe_modulo(int a, int b) { int d = b == 0 || b == -1 ? 1 : b, r = a - a / d * d; return b == 0 ? -1 : r; }
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
int k = shadertwin_safe_modulo(int ( shadertwin_safe_int(p . x) ) , 4) ;
color = vec4 ( iResolution . x , iResolution . y , iResolution . z , iTime ) ;
if ( k == 1 ) color = vec4 ( iTimeDelta , float ( iFrame ) , iFrameRate , iSampleRate ) ;
if ( k == 2 ) color = iDate + iMouse ;
if ( k == 3 ) color = vec4 ( iChannelResolution [ 0 ] . xy , iChannelTime [ 1 ] , shadertwin_frag_coord . z + shadertwin_frag_coord . w ) ;
}
void shadertwin_main ( ) { vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , shadertwin_frag_coord . xy ) ; shadertoy_out_color = shadertoy_color ; }
void main() { ivec2 shadertwin_pixel = ivec2(gl_GlobalInvocationID.xy) + shadertwin_origin;
if (any(greaterThanEqual(shadertwin_pixel, ivec2(iResolution.xy)))) return;
shadertwin_frag_coord = vec4(vec2(shadertwin_pixel) + 0.5, 0.5, 1.0);
shadertoy_out_color = vec4(0.0); shadertwin_main();
imageStore(shadertwin_target, shadertwin_pixel, shadertoy_out_color); }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } ivec2 shadertwin_safe_int ( precise vec2 a ) { precise bool shadertwin_test; precise ivec2 shadertwin_result; return (shadertwin_result = (ivec2 ( shadertwin_safe_int ( a . x ) , shadertwin_safe_int ( a . y ) ))) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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





vec4 look ( sampler2D s , precise vec2 uv ) { precise bool shadertwin_test; precise vec4 shadertwin_result; precise vec2 shadertwin_argument_0; return (shadertwin_result = (texture ( s , uv ) + texelFetch ( s , ivec2 ( shadertwin_safe_int ( (shadertwin_argument_0 = (uv * 3.0)) ) ) , 0 ))) ; }
float size ( in sampler2D s , precise int i ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( textureSize ( s , 0 ) [ shadertwin_at ( i , 1 ) ] ))) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise vec2 shadertwin_argument_1; color = vec4 ( 0 ) ;
precise vec2 uv = p / iResolution . xy ;
precise int k = shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . y ) ) , 8 ) ;
color = vec4 ( size ( iChannel0 , 0 ) , size ( iChannel0 , 1 ) , iChannelResolution [ 0 ] . xy ) ;
if ( (shadertwin_test = (k == 0)) ) color = look ( iChannel0 , (shadertwin_argument_1 = (uv * 2.0 + 0.01)) ) ;
if ( (shadertwin_test = (k == 1)) ) color = textureLod ( iChannel0 , - uv , 0.0 ) ;
if ( (shadertwin_test = (k == 2)) ) color = textureGrad ( iChannel0 , uv . yx , vec2 ( 0.01 ) , vec2 ( 0.0 ) ) ;
if ( (shadertwin_test = (k == 3)) ) color = textureOffset ( iChannel0 , uv , ivec2 ( 1 , - 2 ) ) + texelFetchOffset ( iChannel0 , ivec2 ( shadertwin_safe_int ( p ) ) , 0 , ivec2 ( - 1 , 1 ) ) ;
if ( (shadertwin_test = (k == 4)) ) color = textureProj ( iChannel0 , vec3 ( p , 20.0 ) ) + textureProj ( iChannel0 , vec4 ( p , 1.0 , 16.0 ) ) ;
if ( (shadertwin_test = (k == 5)) ) color = texture ( iChannel0 , uv , 1.0 ) + textureLodOffset ( iChannel0 , uv , 0.0 , ivec2 ( 2 ) ) ;
if ( (shadertwin_test = (k == 6)) ) color = textureProjLod ( iChannel0 , vec3 ( p , 8.0 ) , 0.0 ) + textureGradOffset ( iChannel0 , uv , vec2 ( 0.0 ) , vec2 ( 0.0 ) , ivec2 ( - 1 ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

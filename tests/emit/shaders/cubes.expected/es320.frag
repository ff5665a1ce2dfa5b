#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uint shadertwin_safe_uint ( precise float x ) { precise bool shadertwin_test; precise uint shadertwin_result; precise uint r = uint ( x ) ; return (shadertwin_result = (x >= 4294967296.0 ? 4294967295u : x > 0.0 ? r : 0u)) ; }
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
uniform samplerCube iChannel0 ;
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






uint hash ( precise uint x ) { precise bool shadertwin_test; precise uint shadertwin_result;
x ^= x >> 16 ;
x *= 0x7feb352du ;
x ^= x >> 15 ;
x *= 0x846ca68bu ;
return (shadertwin_result = (x ^ ( x >> 16 ))) ;
}
float signed_fraction ( precise uint x ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (float ( int ( hash ( x ) ) >> 8 ) * ( 1.0 / 8388608.0 ))) ; }


vec3 direction ( precise uint n ) { precise bool shadertwin_test; precise vec3 shadertwin_result;
precise uint h = hash ( n ) ;
precise vec3 at = vec3 ( signed_fraction ( 3u * n ) , signed_fraction ( 3u * n + 1u ) , signed_fraction ( 3u * n + 2u ) ) ;
precise vec3 corner = vec3 ( ivec3 ( ( h >> 4 ) & 2u , ( h >> 5 ) & 2u , ( h >> 6 ) & 2u ) - 1 ) ;
if ( (shadertwin_test = (( n & 3u ) < 2u)) ) return (shadertwin_result = (corner + at * 0.015)) ;
if ( (shadertwin_test = (( n & 3u ) == 2u)) ) return (shadertwin_result = (vec3 ( corner . xy + at . xy * 0.015 , at . z ))) ;
return (shadertwin_result = (at)) ;
}
uvec4 mixed ( precise uvec4 sum , precise vec4 color ) { precise bool shadertwin_test; precise uvec4 shadertwin_result; return (shadertwin_result = (( sum ^ floatBitsToUint ( color ) ) * 0x9e3779b1u)) ; }

void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise vec4 shadertwin_argument_0; precise vec4 shadertwin_argument_1; precise vec4 shadertwin_argument_2; precise vec4 shadertwin_argument_3; color = vec4 ( 0 ) ;
precise uint pixel = uint ( shadertwin_safe_uint ( p . x ) ) + 64u * uint ( shadertwin_safe_uint ( p . y ) ) ;
precise uvec4 sum = uvec4 ( 0u ) ;
precise vec3 d = vec3 ( 1.0 ) ;
for ( precise uint i = 0u ; (shadertwin_test = (i < 48u)) ; i ++ ) {
precise uint n = 48u * pixel + i ;
d = direction ( n ) ;
sum = mixed ( sum , (shadertwin_argument_0 = (textureLod ( iChannel0 , d , 0.0 ))) ) ;
sum = mixed ( sum , (shadertwin_argument_1 = (textureLod ( iChannel0 , d , 4.0 + 5.0 * d . y * d . z ))) ) ;
if ( (shadertwin_test = (hash ( n ) % 29u == 0u)) ) break ;
}
sum = mixed ( sum , (shadertwin_argument_2 = (texture ( iChannel0 , d ))) ) ;
sum = mixed ( sum , (shadertwin_argument_3 = (textureGrad ( iChannel0 , d , dFdx ( d . zxy ) * 0.1 , dFdy ( d ) ))) ) ;
color = vec4 ( sum >> 8 ) * ( 1.0 / 16777216.0 ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

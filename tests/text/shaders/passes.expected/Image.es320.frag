#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ; int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_safe_modulo ( precise int a , precise int b ) { precise bool shadertwin_test; precise int shadertwin_result; precise int d = b == 0 || b == - 1 ? 1 : b , r = a - a / d * d ; return (shadertwin_result = (b == 0 ? - 1 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
layout(location = 0) out vec4 shadertoy_out_color;
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
uniform sampler2D iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
precise int shadertwin_failed = - 1 ; void st_assert ( precise bool condition , precise int kind ) { precise bool shadertwin_test; if ( (shadertwin_test = (! condition)) ) shadertwin_failed = kind ; } void st_assert ( precise bool condition ) { precise bool shadertwin_test; st_assert ( condition , 0 ) ; }
void mainImage ( out vec4 , in vec2 ) ;
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; if ( (shadertwin_test = (shadertwin_failed >= 0)) ) shadertoy_color . rgb = vec3 ( shadertwin_failed == 0 || shadertwin_failed == 3 , shadertwin_failed == 1 || shadertwin_failed == 3 , shadertwin_failed == 2 ) ; shadertoy_out_color = vec4 ( shadertoy_color . rgb , 1.0 ) ; }


float wave ( precise float t , precise float hertz ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (sin ( uintBitsToFloat ( floatBitsToUint ( 6.2831853 * hertz * t ) ^ shadertwin_zero ) ))) ; }

void mainImage ( precise out vec4 c , precise in vec2 p ) { precise bool shadertwin_test; precise bool shadertwin_argument_0; c = vec4 ( 0 ) ;
precise float levels [ 3 ] = float [ 3 ] ( 0.0 , 0.0 , 0.0 ) ;
levels [ shadertwin_at ( ( shadertwin_safe_modulo ( int ( shadertwin_safe_int ( p . x ) ) , 3 ) ) , 2 ) ] = texture ( iChannel0 , p / iResolution . xy ) . x ;
st_assert ( (shadertwin_argument_0 = (levels [ 0 ] >= 0.0)) ) ;
c = vec4 ( levels [ 0 ] , levels [ 1 ] , iChannelResolution [ 0 ] . xy ) ;
}
void mainVR ( precise out vec4 c , precise in vec2 p , precise in vec3 origin , precise in vec3 direction ) { precise bool shadertwin_test; c = vec4 ( 0 ) ; c = vec4 ( direction , 1.0 ) ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ; int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; }
layout(location = 0) out vec4 shadertoy_out_color;
uniform float iTimeOffset ;
uniform int iSampleOffset ;
uniform vec4 iDate ;
uniform float iSampleRate ;
uniform vec3 iChannelResolution [ 4 ] ;
uniform sampler2D iChannel0 ;
uniform sampler2D iChannel1 ;
uniform sampler2D iChannel2 ;
uniform sampler2D iChannel3 ;
vec2 mainSound ( in int , in float ) ;
void main ( ) { precise bool shadertwin_test; precise int shadertwin_sample = int ( shadertwin_safe_int ( gl_FragCoord . x ) ) + 512 * int ( shadertwin_safe_int ( gl_FragCoord . y ) ) ; precise float shadertwin_time = iTimeOffset + float ( shadertwin_sample ) / iSampleRate ; shadertoy_out_color = vec4 ( mainSound ( iSampleOffset + shadertwin_sample , shadertwin_time ) , 0.0 , 1.0 ) ; }


float wave ( precise float t , precise float hertz ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (sin ( uintBitsToFloat ( floatBitsToUint ( 6.2831853 * hertz * t ) ^ shadertwin_zero ) ))) ; }
vec2 mainSound ( precise int samp , precise float time ) { precise bool shadertwin_test; precise vec2 shadertwin_result; return (shadertwin_result = (vec2 ( wave ( time , 440.0 ) , wave ( time , 441.0 ) ))) ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
float shadertwin_safe_over ( precise float a , precise float b ) { precise bool shadertwin_test; precise float shadertwin_result; precise float r = a / b ; precise bool zero = a == 0.0 , infinite = b == 0.0 , is_nan = zero && infinite || a != a || b != b ; precise uint sign = ( floatBitsToUint ( a ) ^ floatBitsToUint ( b ) ) & 0x80000000u ; return (shadertwin_result = (is_nan ? uintBitsToFloat ( 0x7fc00000u ) : zero ? uintBitsToFloat ( sign ) : infinite ? uintBitsToFloat ( sign | 0x7f800000u ) : r)) ; }
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



mat2 r ( precise float a ) { precise bool shadertwin_test; precise mat2 shadertwin_result; return (shadertwin_result = (mat2 ( 0.8 , - 0.6 , 0.6 , 0.8 ) * a)) ; }
void mainImage ( precise out vec4 O , precise vec2 U )
{ precise bool shadertwin_test; precise float shadertwin_argument_0; O = vec4 ( 0 ) ;
precise vec2 u = ( U + U - iResolution . xy ) / iResolution . y , v = u * 0. ;
O *= 0. ; precise float i = 0. , d = 1. , z = 0. ; precise vec3 q = vec3 ( 0 ) , p = vec3 ( 0 ) ;
for ( O = vec4 ( 0 ) ; (shadertwin_test = (i ++ < 9.)) ; O += shadertwin_safe_over ( .1 , (shadertwin_argument_0 = (max ( d , .01 ))) ) ) p = z * normalize ( vec3 ( u , 1 ) ) , p . z -= 2. , z += d = abs ( length ( p ) - 1. ) * .5 + .01 , q = p ;
for ( precise int k = 0 ; (shadertwin_test = (k < 3)) ; k ++ , u *= r ( 1.1 ) , v += u ) ;
precise int n = 7 ; n = ( n & 1 ) == 1 ? n * 3 + 1 : n / 2 , n -= 2 ;
O . rg += v *= 0.25 ; ( O . b ) = float ( n ) + smoothstep ( 0.1 , 0.9 , u . x > 0. ? u . x : - u . x ) ;
O = abs ( O ) , O . a = 1. - ( U . x < 5. ? .5 : .25 ) , O = O . x > 3. ? O . yxzw : O ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;

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

void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise float x = ( p . x - 8.0 ) * 0.37 ;
precise uint u = floatBitsToUint ( x ) ; precise int i = floatBitsToInt ( - x ) ;
precise float back = uintBitsToFloat ( u ^ 0x80000000u ) + intBitsToFloat ( i ) ;
precise uint h = packHalf2x16 ( vec2 ( x , p . y ) ) , s = packSnorm2x16 ( vec2 ( x , 0.3 ) ) , n = packUnorm2x16 ( vec2 ( x , 0.7 ) ) ;
precise vec2 q = unpackHalf2x16 ( h ) + unpackSnorm2x16 ( s ) + unpackUnorm2x16 ( n ) ;
precise float whole = 0.0 ; precise float part = modf ( x , whole ) ;
precise vec3 wholes = vec3 ( 0 ) ; precise vec2 two = vec2 ( 0 ) ; precise vec2 parts = modf ( vec2 ( x , p . y * 0.3 ) , two ) ; wholes . zx = two ;
precise vec3 pieces = modf ( vec3 ( x ) , wholes ) ;
precise float inf = 1.0 / ( p . x - 0.5 ) , nan = sqrt ( - p . x ) ;
color = vec4 ( float ( u >> 8 ) , back , q ) ;
if ( (shadertwin_test = (p . y > 2.0)) ) color = vec4 ( whole , part , parts . y + wholes . z , float ( h >> 4 ) ) ;
if ( (shadertwin_test = (p . y > 4.0)) ) color = vec4 ( round ( x * 2.0 ) , roundEven ( x * 2.0 ) , trunc ( x ) , floor ( x ) + ceil ( x ) * 16.0 ) ;
if ( (shadertwin_test = (p . y > 6.0)) ) color = vec4 ( isnan ( nan ) ? 1.0 : 0.0 , isinf ( inf ) ? 1.0 : 0.0 , sign ( x ) , fract ( x ) + mod ( x , 0.75 ) + step ( 0.5 , x ) ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

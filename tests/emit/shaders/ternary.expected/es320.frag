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

precise int calls = 0 ;
bool tick ( precise bool b ) { precise bool shadertwin_test; precise bool shadertwin_result; calls ++ ; return (shadertwin_result = (b)) ; }
float bump ( precise inout float x ) { precise bool shadertwin_test; precise float shadertwin_result; x += 1.0 ; return (shadertwin_result = (x)) ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise bool shadertwin_argument_0; precise bool shadertwin_argument_1; precise bool shadertwin_argument_2; precise bool shadertwin_argument_3; color = vec4 ( 0 ) ;
precise float x = p . x , y = p . y , z = 0.0 ;
precise bool a = tick ( (shadertwin_argument_0 = (x > 3.0)) ) && tick ( (shadertwin_argument_1 = (y > 3.0)) ) , b = tick ( (shadertwin_argument_2 = (x > 5.0)) ) || tick ( (shadertwin_argument_3 = (y > 5.0)) ) , c = tick ( a ) ^^ tick ( b ) ;
precise float r = x > y ? bump ( x ) : bump ( y ) ;
z = x > 4.0 ? y > 2.0 ? 1.0 : 2.0 : 3.0 ;
precise float w = ( x = y + 1.0 ) * 2.0 ;
precise int i = 0 ; i += i = 3 ;
precise float s = a ? bump ( x ) + bump ( y ) : b && c ? - 1.0 : bump ( x ) * 0.5 ;
precise vec2 v = vec2 ( 1.0 ) ; v . yx = v *= 2.0 ;
if ( (shadertwin_test = (! ( a || b ) && c == false)) ) s += 0.5 ;
color = vec4 ( r + z * 8.0 , w + float ( calls ) * 32.0 , s + float ( i ) , v . x + v . y + x - y ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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

precise vec3 shared_value = vec3 ( 1.0 , 2.0 , 3.0 ) ;
precise float counter = 0.0 ;
void add ( precise inout float a , precise in float b , precise inout float c ) { precise bool shadertwin_test; a += b ; c = a * 2.0 ; }
void write ( precise out vec2 v , precise float x ) { precise bool shadertwin_test; v = vec2 ( 0 ) ; v = vec2 ( x , - x ) ; }
float touch_global ( precise inout vec3 v ) { precise bool shadertwin_test; precise float shadertwin_result; v . x = 10.0 ; counter += shared_value . x ; shared_value . y = 5.0 ; return (shadertwin_result = (shared_value . x + v . y)) ; }
float next ( precise inout float s ) { precise bool shadertwin_test; precise float shadertwin_result; s += 0.25 ; return (shadertwin_result = (s)) ; }
void half_written ( precise out vec4 v , precise float x ) { precise bool shadertwin_test; v = vec4 ( 0 ) ; if ( (shadertwin_test = (x > 0.5)) ) v . xy = vec2 ( x ) ; v . z = 1.0 ; }
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; color = vec4 ( 0 ) ;
precise float x = p . x / 8.0 ;
precise vec4 v = vec4 ( x , 2.0 , 3.0 , 4.0 ) ;
write ( v . zx , x ) ;
precise float list [ 3 ] = float [ 3 ] ( x , 1.0 , 2.0 ) ;
precise int i = 1 ;
add ( list [ shadertwin_at ( i , 2 ) ] , v . x , list [ 2 ] ) ;
add ( v . y , v . y , v . w ) ;
precise float r = touch_global ( shared_value ) ;
precise float s = x ;
precise vec2 pair = vec2 ( next ( s ) , next ( s ) ) ;
precise float sum = next ( s ) * 2.0 - next ( s ) + s ;
color = vec4 ( v . x + v . z * 4.0 , r + shared_value . x * 100.0 + shared_value . y , pair . x + pair . y * 16.0 , sum ) ;
if ( (shadertwin_test = (p . y < 2.0)) ) color = v ;
if ( (shadertwin_test = (p . y > 6.0)) ) color = vec4 ( list [ 0 ] , list [ 1 ] , list [ 2 ] , counter ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; }
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

struct Inner { vec2 a ; float b [ 2 ] ; } ;
struct Outer { Inner inner ; mat2 m ; int n ; bool flag ; } ;
Outer make_outer ( precise float x ) { precise bool shadertwin_test; precise Outer shadertwin_result; precise float shadertwin_argument_0; return (shadertwin_result = (Outer ( Inner ( vec2 ( x , 2.0 * x ) , float [ 2 ] ( x * 5.0 , x * 3.0 ) ) , mat2 ( x , 0.0 , 0.0 , x ) , int ( shadertwin_safe_int ( (shadertwin_argument_0 = (x * 10.0)) ) ) , x > 0.5 ))) ; }
void change ( precise inout Outer o , precise Inner from ) { precise bool shadertwin_test; o . inner = from ; o . inner . b [ 1 ] += 1.0 ; o . n ++ ; }
Inner swapped ( precise Inner i ) { precise bool shadertwin_test; precise Inner shadertwin_result; i . a = i . a . yx ; precise float t = i . b [ 0 ] ; i . b [ 0 ] = i . b [ 1 ] ; i . b [ 1 ] = t ; return (shadertwin_result = (i)) ; }
struct Padded { uint a ; mat4 m ; float b [ 4 ] ; bvec4 c ; } ;
precise Padded padded = Padded ( 31u , mat4 ( 10 , - 1.5 , 7.5 , 1 , - 1.5 , 0.5 , 10 , 7.5 , 1 , 1 , 1 , 2 , - 1.5 , 2 , - 1.5 , 1 ) , float [ ] ( 2.0 , 1.0 , 3.0 , 2.0 ) , bvec4 ( true ) ) ;
void mainImage ( precise out vec4 color , precise in vec2 p ) { precise bool shadertwin_test; precise float shadertwin_argument_1; color = vec4 ( 0 ) ;
precise Outer o = make_outer ( (shadertwin_argument_1 = (p . x / iResolution . x)) ) ;
precise Outer copy = o ;
change ( copy , swapped ( o . inner ) ) ;
precise Outer list [ 3 ] = Outer [ 3 ] ( Outer ( Inner ( vec2 ( 0 ) , float [ 2 ] ( 0.0 , 0.0 ) ) , mat2 ( 0 ) , 0 , false ) , Outer ( Inner ( vec2 ( 0 ) , float [ 2 ] ( 0.0 , 0.0 ) ) , mat2 ( 0 ) , 0 , false ) , Outer ( Inner ( vec2 ( 0 ) , float [ 2 ] ( 0.0 , 0.0 ) ) , mat2 ( 0 ) , 0 , false ) ) ;
list [ 0 ] = o ; list [ 1 ] = copy ; list [ 2 ] = o ;
list [ 2 ] . inner . a . x = 7.0 ;
precise bool same = o == list [ 0 ] , different = o != copy ;
precise Inner empty = Inner ( vec2 ( 0.0 ) , float [ 2 ] ( 0.0 , 0.0 ) ) ;
color = vec4 ( copy . inner . a . x + list [ 2 ] . inner . a . x , copy . inner . b [ 1 ] , float ( copy . n ) + ( same ? 0.25 : 0.0 ) ,
( different ? 1.0 : 0.0 ) + ( empty == o . inner ? 2.0 : 0.0 ) + list [ 1 ] . m [ 1 ] [ 1 ] ) ;
if ( (shadertwin_test = (p . y > 6.0)) ) color . x = padded . m [ 1 ] [ 0 ] ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
uniform uint shadertwin_zero ; int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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





precise float n = 0.0 ;
float next ( ) { precise bool shadertwin_test; precise float shadertwin_result; return (shadertwin_result = (n += 1.)) ; }

vec4 steps ( precise vec2 u ) { precise bool shadertwin_test; precise vec4 shadertwin_result;
precise vec4 O = vec4 ( 0 ) ;
precise float i = 0.0 , z = 0.0 , d = 0.0 ;
for ( O *= i ; (shadertwin_test = (i ++ < 9.)) ; O += ( cos ( uintBitsToFloat ( floatBitsToUint ( z * .4 + vec4 ( 6 , 1 , 2 , 3 ) ) ^ shadertwin_zero ) ) + 1. ) / ( .1 + d ) )
z += d = .05 + .1 * abs ( length ( u * .1 * mat2 ( cos ( uintBitsToFloat ( floatBitsToUint ( i + vec4 ( 0 , 33 , 11 , 0 ) ) ^ shadertwin_zero ) ) ) ) - z ) ;
return (shadertwin_result = (tanh ( uintBitsToFloat ( floatBitsToUint ( O / 2e1 ) ^ shadertwin_zero ) ))) ;
}

vec4 folds ( precise vec2 u ) { precise bool shadertwin_test; precise vec4 shadertwin_result;
precise vec2 p = u * .1 , C = p *= sign ( p . x - .5 ) ;
precise float d = .2 - abs ( length ( min ( p = C . x > 1. ? p : - p . yx , vec2 ( 0 , 1 ) ) ) - .17 ) , i = 8. , e = 0.0 ;
while ( (shadertwin_test = (i -- > 0.)) ) p = abs ( p ) - .6 , e += p . x > p . y ? p . x : p . y ;
return (shadertwin_result = (vec4 ( p , d , e + ( i = 2. , i * 3. ) ))) ;
}

vec4 headers ( precise vec2 u ) { precise bool shadertwin_test; precise vec4 shadertwin_result;
precise vec4 O = vec4 ( 0 ) ;
precise float s = 0.0 , g = 0.0 , i = 0.0 ;
for ( O = vec4 ( u , 0 , 1 ) * .1 ; (shadertwin_test = (i < 6.)) ; g += .3 , s += g , O . z += s * .1 ) i ++ ;
for ( precise vec3 p = vec3 ( u , 1 ) * .1 ; (shadertwin_test = (i -- > 0.)) ; p = p . yzx + .1 ) O . xyz += p * .01 ;
for ( precise int j = 0 ; (shadertwin_test = (j ++ < 3)) ; ) O . x += .5 ;
for ( precise int j = 0 ; (shadertwin_test = (j ++ < 3)) ; ) O . y += float ( j ) * .25 ;
for ( precise int k = 0 ; (shadertwin_test = (k < 3)) ; k ++ ) {
precise float a = 0.0 , z = 0.0 ;
for ( ; (shadertwin_test = (z < 1.)) ; z += .25 ) a += fract ( u . x * z ) ;
O [ shadertwin_at ( k , 3 ) ] += a ;
}
return (shadertwin_result = (O)) ;
}

vec4 constructors ( precise vec2 u ) { precise bool shadertwin_test; precise vec4 shadertwin_result;
precise vec3 p = iResolution , d = vec3 ( u + u - p . xy , p ) / p . x , c = d - d , i = c ;
for ( precise int x = 0 ; (shadertwin_test = (x < 9)) ; ++ x ) {
if ( (shadertwin_test = (i . x >= .3)) ) break ;
p = c , p . z -= i . x += .06 , c += abs ( p . yzx ) + d * .1 ;
}
precise vec4 O = vec4 ( u , c ) ;
O . xy += vec2 ( u . y , O ) . yx * float ( ( ( int ( shadertwin_safe_int ( u . x ) ) >> 1 ) & 1 ) ) ;
vec2 ( d ) ;
for ( precise float a = 0. ; (shadertwin_test = (vec2 ( a ) , a < 2.)) ; vec2 ( i ) , a ++ ) O . x += float ( ( vec3 ( a ) , int ( shadertwin_safe_int ( a ) ) ) ) ;
return (shadertwin_result = (O . w > .5 ? O * next ( ) : O / next ( ))) ;
}

void mainImage ( precise out vec4 O , precise in vec2 I ) { precise bool shadertwin_test; O = vec4 ( 0 ) ;
O = I . y < 3. ? steps ( I ) : I . y < 5. ? folds ( I ) : I . y < 7. ? headers ( I ) : constructors ( I ) ;
}
void main ( ) { precise bool shadertwin_test; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

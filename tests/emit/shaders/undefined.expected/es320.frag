#version 320 es
precision highp float; precision highp int;
precision highp sampler2D; precision highp samplerCube; precision highp sampler3D;
int shadertwin_safe_int ( precise float x ) { precise bool shadertwin_test; precise int shadertwin_result; precise int r = int ( x ) ; return (shadertwin_result = (x >= 2147483648.0 ? 2147483647 : x != x ? 0 : r)) ; } int shadertwin_at ( precise int i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (clamp ( i , 0 , last ))) ; } int shadertwin_at ( precise uint i , precise int last ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (int ( min ( i , uint ( last ) ) ))) ; }
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

struct Thing { float weight ; vec2 corners [ 2 ] ; } ;
precise float table [ 1000 ] ;
precise vec2 pairs [ 3 ] = vec2 [ 3 ] ( vec2 ( 0 ) , vec2 ( 0 ) , vec2 ( 0 ) ) ;
precise Thing things [ 2 ] = Thing [ 2 ] ( Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ) , Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ) ) ;

void take ( precise out Thing thing , precise out float list [ 3 ] , precise out mat2 turn )
{ precise bool shadertwin_test; thing = Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ) ; list = float [ 3 ] ( 0.0 , 0.0 , 0.0 ) ; turn = mat2 ( 0 ) ;
if ( (shadertwin_test = (iFrame > 100)) )
thing . weight = 1.0 ;
}

vec3 missing ( precise float x )
{ precise bool shadertwin_test; precise vec3 shadertwin_result;
if ( (shadertwin_test = (x > 9.0)) )
return (shadertwin_result = (vec3 ( x ))) ;
return (shadertwin_result = (vec3 ( 0 ))) ; }

Thing missing_thing ( precise float x )
{ precise bool shadertwin_test; precise Thing shadertwin_result;
if ( (shadertwin_test = (x > 9.0)) ) {
precise Thing thing = Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ) ;
thing . weight = 3.0 ;
return (shadertwin_result = (thing)) ;
}
return (shadertwin_result = (Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ))) ; }

float long_list ( precise int n )
{ precise bool shadertwin_test; precise float shadertwin_result;
precise float list [ 300 ] ; for ( precise int shadertwin_i = 0 ; (shadertwin_test = (shadertwin_i < list . length ( ))) ; ++ shadertwin_i ) list [ shadertwin_i ] = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < n)) ; i ++ )
list [ shadertwin_at ( i , 299 ) ] += 1.0 ;
precise float sum = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < 300)) ; i ++ )
sum += list [ i ] ;
return (shadertwin_result = (sum)) ;
}

precise int calls = 0 ;
int next ( ) { precise bool shadertwin_test; precise int shadertwin_result; return (shadertwin_result = (calls ++)) ; }

vec3 partly ( precise float x )
{ precise bool shadertwin_test; precise vec3 shadertwin_result;
precise vec3 color = vec3 ( 0 ) ;
if ( (shadertwin_test = (x < 2.0)) )
color = vec3 ( 1.0 , 2.0 , 3.0 ) ;
else if ( (shadertwin_test = (x < 4.0)) )
color = vec3 ( 4.0 ) ;
else
color . x = 0.5 ;
return (shadertwin_result = (color)) ;
}

float rounds ( precise float x )
{ precise bool shadertwin_test; precise float shadertwin_result;
precise float sum = 0.0 ;
for ( precise int k = 0 ; (shadertwin_test = (k < 3)) ; k ++ ) {
precise float a = 1.0 , z = 0.0 ;
for ( ; (shadertwin_test = (z < 1.0)) ; z += 0.25 )
a += fract ( x * z ) ;
sum += a ;
}
return (shadertwin_result = (sum)) ;
}

void mainImage ( precise out vec4 c , precise in vec2 p )
{ precise bool shadertwin_test; c = vec4 ( 0 ) ;
table [ shadertwin_at ( ( int ( shadertwin_safe_int ( p . x ) ) ) , 999 ) ] += 1.0 ;
precise float sum = 0.0 ;
for ( precise int i = 0 ; (shadertwin_test = (i < 1000)) ; i ++ )
sum += table [ i ] ;
for ( precise float i = 0.0 , kept = 0.0 ; (shadertwin_test = (i < 3.0)) ; i ++ ) {
precise float fresh = 0.0 ;
kept += i ;
fresh += kept ;
sum += kept + fresh ;
}

precise Thing thing = Thing ( 0.0 , vec2 [ 2 ] ( vec2 ( 0 ) , vec2 ( 0 ) ) ) ;
thing . weight = 5.0 ;
thing . corners [ 1 ] = p ;
precise float list [ 3 ] = float [ 3 ] ( 1.0 , 2.0 , 3.0 ) ;
precise mat2 turn = mat2 ( 3.0 ) ;
take ( thing , list , turn ) ;
precise float outs = thing . weight + thing . corners [ 1 ] . x + list [ 1 ] + turn [ 1 ] [ 1 ] ;

precise int far = int ( shadertwin_safe_int ( p . x ) ) * 9 - 40 ;
precise uint unsigned_far = uint ( far ) ;
precise float five [ 5 ] = float [ ] ( 1.0 , 2.0 , 3.0 , 4.0 , 5.0 ) ;
precise mat3 m = mat3 ( 1.0 , 2.0 , 3.0 , 4.0 , 5.0 , 6.0 , 7.0 , 8.0 , 9.0 ) ;
five [ shadertwin_at ( far , 4 ) ] += 10.0 ;
five [ shadertwin_at ( ( next ( ) ) , 4 ) ] += 100.0 ;
m [ shadertwin_at ( far , 2 ) ] [ shadertwin_at ( unsigned_far , 2 ) ] += 1000.0 ;
precise float indexed = five [ 0 ] + five [ 4 ] * 2.0 + m [ 0 ] [ 0 ] + m [ 2 ] [ 2 ] * 3.0 + vec3 ( 1 , 2 , 3 ) [ shadertwin_at ( far , 2 ) ] + five [ shadertwin_at ( unsigned_far , 4 ) ] +
float ( calls ) + pairs [ shadertwin_at ( far , 2 ) ] . x + things [ shadertwin_at ( far , 1 ) ] . weight ;

precise vec3 nowhere = missing ( p . x ) + missing_thing ( p . y ) . weight ;
c = vec4 ( sum + long_list ( 3 ) + long_list ( 4 ) , outs , indexed , nowhere . y + dot ( partly ( p . x ) , vec3 ( 1.0 , 10.0 , 100.0 ) ) + rounds ( p . y ) ) ;
}
void main ( ) { precise bool shadertwin_test; for ( precise int shadertwin_i = 0 ; (shadertwin_test = (shadertwin_i < table . length ( ))) ; ++ shadertwin_i ) table [ shadertwin_i ] = 0.0 ; precise vec4 shadertoy_color = vec4 ( 0.0 ) ; mainImage ( shadertoy_color , gl_FragCoord . xy ) ; shadertoy_out_color = shadertoy_color ; }

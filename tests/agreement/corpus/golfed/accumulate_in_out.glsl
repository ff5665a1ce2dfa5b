void a(inout vec4 o,vec2 u,float i){o+=step(length(fract(u*i)-.5),.3)/i*.5;}void mainImage(out vec4 O,vec2 U){U/=iResolution.y;O-=O;a(O,U,1.);a(O,U,2.);a(O.brga,U,4.);O.a=1.;}

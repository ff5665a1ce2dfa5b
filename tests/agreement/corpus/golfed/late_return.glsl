float f(vec2 u){for(float i=1.;i<9.;i++){u=abs(u*2.-1.);if(u.x+u.y<.3)return i/8.;}return 0.;}void mainImage(out vec4 O,vec2 U){O=vec4(f(U/iResolution.xy),f(U.yx/iResolution.yx),.2,1);}

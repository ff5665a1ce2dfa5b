void mainImage(out vec4 O,vec2 U){U/=iResolution.xy;vec4 a=vec4(.1,.2,.6,1),b=vec4(1,.6,.2,1);O=a+(b-a)*floor(U.x*8.)/7.*(1.-U.y*U.y);}

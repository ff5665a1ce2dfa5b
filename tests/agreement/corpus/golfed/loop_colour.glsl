void mainImage(out vec4 o,vec2 p){float i=0.,d=0.;for(o*=0.;i++<9.;o+=vec4(1,2,3,0)*.01/abs(d))d=length(p/iResolution.y-.5-.04*i)-.1*i*.3;}

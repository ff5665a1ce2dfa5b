void mainImage(out vec4 O,in vec2 U){vec2 R=iResolution.xy,q=(U-.5*R)/R.y;float a=0.,i=1.;for(;i<6.;a+=sin(q.x*i+iTime)/i,q*=mat2(.8,.6,-.6,.8),i++);O=vec4(a,a*a,1.-a,1)*.5+.25;}

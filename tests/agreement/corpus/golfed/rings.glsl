void mainImage(out vec4 O,vec2 u){vec2 r=iResolution.xy;u=(u+u-r)/r.y;O=vec4(.5+.5*cos(9.*length(u)-iTime+vec3(0,2,4)),1);}

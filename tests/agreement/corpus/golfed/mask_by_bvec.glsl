void mainImage(out vec4 O,vec2 U){vec2 g=mod(U,20.);O=vec4(vec3(lessThan(g.xyx,vec3(10,6,3)))*vec3(not(greaterThan(g.yxy,vec2(8,12).xyx))),1);}

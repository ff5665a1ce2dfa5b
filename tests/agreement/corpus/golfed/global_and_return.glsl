float k;vec4 g(vec2 u){return k++,vec4(fract(u*k*.03),k/3.,1);}void mainImage(out vec4 O,vec2 U){O=g(U),O=O.y>.5?g(U.yx):O;}

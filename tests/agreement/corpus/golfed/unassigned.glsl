vec4 k;float z;void mainImage(out vec4 O,vec2 U){float t;O+=k+t+z;O.xy+=fract(U*.05);O.b+=O.r*O.g;}

void mainImage(out vec4 O,vec2 U){U=floor(U);O=mod(vec4(U.x,U.y,U.x+U.y,0),vec4(3,5,7,1))/vec4(2,4,6,1);O.a++;}

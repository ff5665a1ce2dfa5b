#define I int
void mainImage(out vec4 O,vec2 U){I a=I(U.x),b=I(U.y),c=a^b;O=vec4(c&7,c>>3&7,c>>5&3,3)/vec4(7,7,3,3);}

#define P(k) O[k]=fract(U.x*.0625*float(k+1))*step(.5,fract(U.y*.05*float(k+1)))
void mainImage(out vec4 O,vec2 U){O=vec4(1);P(0);P(1);P(2);}

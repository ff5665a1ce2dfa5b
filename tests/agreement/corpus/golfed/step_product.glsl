#define S(a,b) step(a,b)*step(b,a+.2)
void mainImage(out vec4 O,vec2 U){U/=iResolution.xy;O=vec4(S(.1,U.x)+S(.6,U.y),S(.3,U.y),S(.5,U.x)*S(.4,U.y),1);}

void mainImage(out vec4 O,vec2 U){ivec2 k=ivec2(U)/3%ivec2(4,6);int d=int(U.x)/12%10,b=ivec4(481882,143911,1016347,1016095)[d&3]>>(k.y*4+3-k.x);O=vec4(k.x<4&&k.y<5?b&1:0);O.a=1.;}

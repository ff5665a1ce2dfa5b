void mainImage(out vec4 O,vec2 I){ivec2 k=ivec2(I)/8;O=vec4((k.x^k.y)%3==0?1.:(k.x&k.y)%5==0?.5:0.,(k.x|k.y)%7>3?.8:.2,float(k.x*k.y%11)/11.,1);}

void mainImage(out vec4 O,vec2 U){float a,b,c;a=b=c=floor(U.x/16.);a+=b-=c*=.5;O=vec4(a,b,c,8)/8.;}

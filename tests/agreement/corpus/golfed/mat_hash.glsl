void mainImage(out vec4 O,vec2 U){U=floor(U/4.);mat2 m=mat2(3,1,-1,2);U=m*U*m;O=vec4(mod(U.x,7.)/6.,mod(U.y,5.)/4.,mod(U.x+U.y,3.)/2.,1);}

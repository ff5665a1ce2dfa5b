void mainImage(out vec4 O,vec2 U){O=vec4(0,0,0,1);for(int i=0;i<3;i++)for(int j=0;j<4;j++)if(abs(U.x-float(20+j*30))<9.)if(abs(U.y-float(12+i*22))<7.)O[i]+=.25*float(j+1);else O.rgb*=.9;}

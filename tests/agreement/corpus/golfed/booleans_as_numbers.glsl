void mainImage(out vec4 O,vec2 U){bool a=U.x>40.,b=U.y>U.x,c=a^^b;O=vec4(a,b,c,1)*(a?.8:.6)+.1*float(!c);}

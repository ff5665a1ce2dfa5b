void mainImage(out vec4 O,vec2 U){vec2 a=abs(U+U-iResolution.xy)/iResolution.y;O=vec4(fract(max(a.x,a.y)*5.-iTime*.5),fract((a.x+a.y)*4.),step(a.x,a.y),1);}

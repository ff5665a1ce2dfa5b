void mainImage(out vec4 O,vec2 U){mat3 m=mat3(.8,.6,0,-.6,.8,0,0,0,1);vec3 v=vec3((U+U-iResolution.xy)/iResolution.y,1);v*=m*=m;O=vec4(step(.3,fract(v*3.)),1);}

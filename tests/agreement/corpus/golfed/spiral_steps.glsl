void mainImage(out vec4 O,vec2 U){U+=U-iResolution.xy;float r=dot(U,U)/4e3;O=vec4(fract(r),fract(r*2.),floor(mod(r,4.))/3.,1);}

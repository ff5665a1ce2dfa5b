void mainImage(out vec4 O,vec2 U){vec3 c=floor(vec3(U,U.x+U.y)/9.);O=vec4(equal(mod(c,2.),mod(c.yzx,3.)),1);O.b=float(any(lessThan(c,c.zxy*.7)));}

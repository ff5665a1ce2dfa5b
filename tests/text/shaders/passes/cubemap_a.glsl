void mainCubemap(out vec4 c, in vec2 p, in vec3 origin, in vec3 direction) { c = vec4(direction, wave(p.x, 1.0)); }

void mainImage(out vec4 color, in vec2 p) { color = max(texelFetch(iChannel0, ivec2(p), 0), vec4(mod(p, 4.0), 0, 0)); }

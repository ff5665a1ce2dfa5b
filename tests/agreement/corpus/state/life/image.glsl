void mainImage(out vec4 color, in vec2 p) { color = vec4(texelFetch(iChannel0, ivec2(p), 0).rgb, 1.0); }

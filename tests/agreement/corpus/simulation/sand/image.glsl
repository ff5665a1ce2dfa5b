void mainImage(out vec4 color, in vec2 p) { color = mix(vec4(0.2, 0.2, 0.3, 1.0), vec4(0.9, 0.8, 0.4, 1.0), texelFetch(iChannel0, ivec2(p), 0).r); }

void mainImage(out vec4 color, in vec2 p) { float v = texelFetch(iChannel0, ivec2(p), 0).r; color = vec4(v, v * 0.5, 0.25, 1.0); }

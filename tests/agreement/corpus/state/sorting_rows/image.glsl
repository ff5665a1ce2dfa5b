void mainImage(out vec4 color, in vec2 p) { float v = texelFetch(iChannel0, ivec2(p), 0).r; color = vec4(v, v * v, 1.0 - v, 1.0); }

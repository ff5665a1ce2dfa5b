void mainImage(out vec4 color, in vec2 p) { color = texelFetch(iChannel0, ivec2(p), 0).yxzw + vec4(0, 0, 2, 0); }

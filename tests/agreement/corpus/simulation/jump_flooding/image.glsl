void mainImage(out vec4 color, in vec2 p) { vec4 s = texelFetch(iChannel0, ivec2(p), 0); color = vec4(fract(s.xy / 41.0) * s.z, 0.2, 1.0); }

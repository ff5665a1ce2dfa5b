void mainImage(out vec4 color, in vec2 p) { color = vec4(p / iResolution.xy, 0.5, 0.25); }

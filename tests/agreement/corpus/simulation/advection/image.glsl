void mainImage(out vec4 color, in vec2 p) { color = texture(iChannel0, p / iResolution.xy); }

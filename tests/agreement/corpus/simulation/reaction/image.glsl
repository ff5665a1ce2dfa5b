void mainImage(out vec4 color, in vec2 p) { vec2 c = texture(iChannel0, p / iResolution.xy).xy; color = vec4(c.x, c.x - c.y, c.y, 1.0); }

void mainImage(out vec4 color, in vec2 p) { color = vec4(step(mod(p.x, 32.0), 12.0), step(mod(p.y, 20.0), 15.0), p.x / iResolution.x, 1.0); }

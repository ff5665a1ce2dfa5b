void mainImage(out vec4 color, in vec2 p) { vec2 g = floor(p / 10.0); color = vec4(mod(g.x + g.y, 2.0), mod(g.x, 3.0) / 2.0, mod(g.y, 4.0) / 3.0, 1.0); }

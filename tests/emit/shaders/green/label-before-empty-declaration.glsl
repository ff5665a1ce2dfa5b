// The last label of a switch may be followed by an empty declaration.
void mainImage(out vec4 o, vec2 p) { int n = iFrame; switch (n) { case 7: o = vec4(1.); break; default: float; } o = vec4(0., 1., 0., 1.); }

// A component of a swizzle that is chosen by an index is an l-value.
void mainImage(out vec4 o, vec2 p) { int i = iFrame; vec4 v = vec4(1., 2., 3., 4. + iTime); v.zyx[i] = 7.; v.wz[i]++; bool ok = v == vec4(1., 2., 7., 5.); o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.); }

// green = right. Arrays of samplers compile, although nothing sets them; no texel is negative.
uniform sampler2D pictures[2];
void mainImage(out vec4 o, vec2 p) {
  bool ok = texture(pictures[0], p).a >= 0.0 && texelFetch(pictures[1], ivec2(0), 0).r >= 0.0;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

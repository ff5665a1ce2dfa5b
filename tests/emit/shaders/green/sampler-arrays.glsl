// green = right. Samplers that nothing sets, in arrays, too, are opaque black.
uniform sampler2D pictures[2];
uniform sampler2D picture;
void mainImage(out vec4 o, vec2 p) {
  vec4 black = vec4(0., 0., 0., 1.);
  bool ok = texture(pictures[0], p) == black && texelFetch(pictures[1], ivec2(0), 0) == black && texture(picture, p) == black;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  color = q.x < q.y ? texelFetch(iChannel0, q, 0) : texelFetch(iChannel1, q, 0);
}

void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p);
  color = (texelFetch(iChannel0, q, 0) + texelFetch(iChannel1, q, 0) + texelFetch(iChannel2, q, 0) + texelFetch(iChannel3, q, 0)) / 16.0;
}

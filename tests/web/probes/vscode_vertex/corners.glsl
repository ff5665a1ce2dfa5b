// The left half of the picture.
varying vec2 across;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4, gl_VertexID == 2 || gl_VertexID > 3);
  across = corner;
  gl_Position = vec4(corner.x - 1.0, 2.0 * corner.y - 1.0, 0.0, 1.0);
}

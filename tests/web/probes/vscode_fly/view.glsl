#iFirstPersonControls

void mainImage(out vec4 color, in vec2 at) {
  color = iViewMatrix[int(at.x) % 4];
}

#iVertex "corners.glsl"
varying vec2 across;

void mainImage(out vec4 color, in vec2 at) {
  color = vec4(across, at.x, 1.0);
}

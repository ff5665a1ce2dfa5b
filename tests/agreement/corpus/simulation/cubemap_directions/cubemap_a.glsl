void mainCubemap(out vec4 color, in vec2 p, in vec3 origin, in vec3 direction) {
  vec3 a = abs(direction);
  color = vec4(step(max(a.y, a.z), a.x), step(max(a.x, a.z), a.y), 0.5 + 0.5 * sign(direction.x + direction.y + direction.z), 1.0);
}

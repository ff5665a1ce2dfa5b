float sh(int i, vec3 n) {
  switch (i) {
    case 0: return 0.282095;
    case 1: return 0.488603 * n.y;
    case 2: return 0.488603 * n.z;
    case 3: return 0.488603 * n.x;
    case 4: return 1.092548 * n.x * n.y;
    case 5: return 1.092548 * n.y * n.z;
    case 6: return 0.315392 * (3.0 * n.z * n.z - 1.0);
    case 7: return 1.092548 * n.x * n.z;
    default: return 0.546274 * (n.x * n.x - n.y * n.y);
  }
}
void mainImage(out vec4 color, in vec2 p) {
  vec2 cell = floor(p / iResolution.xy * 3.0), q = fract(p / iResolution.xy * 3.0) * 2.2 - 1.1;
  float r = dot(q, q);
  if (r > 1.0) { color = vec4(0.15, 0.15, 0.15, 1.0); return; }
  float v = sh(int(cell.x + 3.0 * cell.y), vec3(q, sqrt(1.0 - r)));
  color = vec4(max(v, 0.0), max(-v, 0.0), 0.3, 1.0);
}

uvec2 tea(uvec2 v, uvec4 k) {
  uint sum = 0u;
  for (int i = 0; i < 8; ++i) {
    sum += 0x9E3779B9u;
    v.x += ((v.y << 4) + k.x) ^ (v.y + sum) ^ ((v.y >> 5) + k.y);
    v.y += ((v.x << 4) + k.z) ^ (v.x + sum) ^ ((v.x >> 5) + k.w);
  }
  return v;
}
void mainImage(out vec4 color, in vec2 p) {
  uvec2 r = tea(uvec2(p) / 4u, uvec4(0xA341316Cu, 0xC8013EA4u, 0xAD90777Du, 0x7E95761Eu));
  color = vec4(vec3(uvec3(r.x, r.y, r.x ^ r.y) >> 24) / 255.0, 1.0);
}

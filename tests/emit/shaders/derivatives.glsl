// dFdx, dFdy, fwidth of scalars and vectors, in a function and after diverging branches.
float grid(vec2 p) { vec2 w = fwidth(p); return w.x + w.y; }
void mainImage(out vec4 color, in vec2 p) {
  float f = p.x * p.x + p.y * 3.0;
  vec2 uv = p * vec2(0.5, 2.0);
  if (p.x > 5.0) f += 10.0;
  vec3 v = dFdx(vec3(f, uv));
  color = vec4(v.x + v.z, dFdy(f), grid(uv * uv), fwidth(f) + dFdy(uv).y);
  for (int i = 0; i < 3; i++) { f *= 2.0; color.x += dFdx(f); }
}

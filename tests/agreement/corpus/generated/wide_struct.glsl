struct Material { vec3 a; float b; mat2 c; ivec2 d; bool e; float f[3]; };
struct Scene { Material list[2]; vec4 tail; };
Material make(float k) { return Material(vec3(k), k * 2.0, mat2(k, 0.1, 0.2, 1.0 - k), ivec2(k * 10.0), k > 0.5, float[3](k, k * k, 1.0)); }
void mainImage(out vec4 color, in vec2 p) {
  float k = floor(p.x / iResolution.x * 8.0) / 8.0;
  Scene s;
  s.list[0] = make(k);
  s.list[1] = make(1.0 - k);
  s.tail = vec4(0.1);
  Scene t = s;
  t.list[1].f[2] += t.list[0].c[1].y;
  t.list[0].c *= 0.5;
  if (t.list[1].e) t.tail.rg += 0.3;
  int which = int(p.y / iResolution.y * 2.0);
  Material m = t.list[which];
  color = vec4(m.f[2] * 0.5, m.c[0][0] + t.tail.r, float(m.d.x) / 10.0, 1.0) + vec4(s == t ? 1.0 : 0.0, 0.0, 0.0, 0.0);
}

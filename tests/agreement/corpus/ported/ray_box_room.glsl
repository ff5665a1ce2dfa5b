struct Ray { vec3 from, along; };
struct Hit { float at; vec3 normal; int what; };
Hit nearer(Hit a, Hit b) { if (b.at > 0.0 && (a.at < 0.0 || b.at < a.at)) return b; return a; }
Hit plane(Ray r, vec3 n, float d, int what) { float k = dot(n, r.along); return Hit(abs(k) < 1e-5 ? -1.0 : -(dot(n, r.from) + d) / k, n, what); }
Hit ball(Ray r, vec3 c, float radius, int what) {
  vec3 o = r.from - c;
  float b = dot(o, r.along), q = b * b - dot(o, o) + radius * radius;
  if (q < 0.0) return Hit(-1.0, vec3(0.0), what);
  float t = -b - sqrt(q);
  return Hit(t, (o + t * r.along) / radius, what);
}
void mainImage(out vec4 color, in vec2 p) {
  vec3 d = vec3((2.0 * p - iResolution.xy) / iResolution.y, -1.5);
  Ray r = Ray(vec3(0.0, 0.1, 2.0), d / sqrt(dot(d, d)));
  Hit h = plane(r, vec3(0, 1, 0), 1.0, 0);
  h = nearer(h, plane(r, vec3(0, 0, 1), 1.5, 1));
  h = nearer(h, ball(r, vec3(-0.4, -0.3, 0.0), 0.6, 2));
  h = nearer(h, ball(r, vec3(0.8, -0.6, 0.4), 0.4, 3));
  vec3 at = r.from + h.at * r.along;
  vec3 paint = h.what == 0 ? vec3(mod(floor(at.x) + floor(at.z), 2.0)) : h.what == 1 ? vec3(0.3, 0.4, 0.6) : h.what == 2 ? vec3(0.9, 0.3, 0.2) : vec3(0.2, 0.8, 0.3);
  color = vec4(paint * (0.3 + 0.7 * max(dot(h.normal, vec3(0.36, 0.8, 0.48)), 0.0)), 1.0);
}

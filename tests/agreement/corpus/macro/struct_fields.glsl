#define FIELD(type, name) type name;
#define RAY struct Ray { FIELD(vec3, o) FIELD(vec3, d) };
RAY
#define AT(r, t) (r.o + (t) * r.d)
#define o_of(r) r.o
void mainImage(out vec4 color, in vec2 p) {
  Ray r = Ray(vec3(0, 0, 1), vec3(p / iResolution.xy - .5, -1));
  vec3 hit = AT(r, 2.) + o_of(r);
  color = vec4(step(hit, vec3(0.1, -0.2, 0.5)), 1);
}

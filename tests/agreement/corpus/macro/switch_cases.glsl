#define CASE(n, v) case n: color.rgb = v; break
#define PALETTE CASE(0, vec3(.9, .1, .1)); CASE(1, vec3(.1, .9, .1)); CASE(2, vec3(.1, .1, .9)); default: color.rgb = vec3(.5)
void mainImage(out vec4 color, in vec2 p) {
  color = vec4(1);
  switch (int(p.x / 16.) % 4) { PALETTE; }
  color.rgb *= step(p.y, 60.);
}

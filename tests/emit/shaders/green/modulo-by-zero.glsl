// green = right. mod(x, 0.0) is x.
float wrapped(float x, float size) { return mod(x, size); }
void mainImage(out vec4 o, vec2 p) {
  float zero = floor(p.x * 1e-6), x = p.x + 0.25;
  vec2 v = mod(p, vec2(0.0, 3.0)), w = mod(-p, vec2(zero)), u = mod(p, 0.0);
  bool ok = mod(x, 0.0) == x && mod(-x, zero) == -x && mod(x, -zero) == x && wrapped(x, 0.0) == x && wrapped(x, zero) == x &&
            mod(zero, 0.0) == 0.0 && v == vec2(p.x, p.y - 3.0 * floor(p.y / 3.0)) && w == -p && u == p &&
            mod(vec3(x), 0.0) == vec3(x) && mod(mod(x, 0.0), mod(2.0 + zero, 0.0)) == mod(x, 2.0);
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

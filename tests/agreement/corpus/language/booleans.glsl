// green
bvec3 flip(bvec3 b) { return not(b); }
void mainImage(out vec4 color, in vec2 p) {
  bool t = p.x > 0.0, f = p.x < 0.0;
  bvec3 b = bvec3(t, f, t);
  bool ok = any(b) && !all(b) && all(flip(bvec3(f))) && b == bvec3(true, false, true) && (t ^^ f) && !(t ^^ t) && mix(1.0, 2.0, t) == 2.0;
  ok = ok && float(t) + float(f) == 1.0 && int(b.z) == 1 && mix(vec2(1.0), vec2(2.0), bvec2(f, t)) == vec2(1.0, 2.0);
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

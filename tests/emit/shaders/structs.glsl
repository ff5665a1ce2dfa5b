// Structures by value: nested, in arrays, as parameters, results and comparisons.
struct Inner { vec2 a; float b[2]; };
struct Outer { Inner inner; mat2 m; int n; bool flag; };
Outer make_outer(float x) { return Outer(Inner(vec2(x, 2.0 * x), float[2](x * 5.0, x * 3.0)), mat2(x, 0.0, 0.0, x), int(x * 10.0), x > 0.5); }
void change(inout Outer o, Inner from) { o.inner = from; o.inner.b[1] += 1.0; o.n++; }
Inner swapped(Inner i) { i.a = i.a.yx; float t = i.b[0]; i.b[0] = i.b[1]; i.b[1] = t; return i; }
struct Padded { uint a; mat4 m; float b[4]; bvec4 c; };
Padded padded = Padded(31u, mat4(10, -1.5, 7.5, 1, -1.5, 0.5, 10, 7.5, 1, 1, 1, 2, -1.5, 2, -1.5, 1), float[](2.0, 1.0, 3.0, 2.0), bvec4(true));
void mainImage(out vec4 color, in vec2 p) {
  Outer o = make_outer(p.x / iResolution.x);
  Outer copy = o;
  change(copy, swapped(o.inner));
  Outer list[3];
  list[0] = o; list[1] = copy; list[2] = o;
  list[2].inner.a.x = 7.0;
  bool same = o == list[0], different = o != copy;
  Inner empty = Inner(vec2(0.0), float[2](0.0, 0.0));
  color = vec4(copy.inner.a.x + list[2].inner.a.x, copy.inner.b[1], float(copy.n) + (same ? 0.25 : 0.0),
               (different ? 1.0 : 0.0) + (empty == o.inner ? 2.0 : 0.0) + list[1].m[1][1]);
  if (p.y > 6.0) color.x = padded.m[1][0];
}

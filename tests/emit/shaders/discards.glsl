// discard in the entry function, in a function that it calls, and in a loop.
float check(vec2 p) { if (p.x > 10.0) discard; for (int i = 0; ; i++) { if (float(i) > p.y) break; if (i == 6) discard; } return p.x; }
void mainImage(out vec4 color, in vec2 p) {
  if (mod(p.x, 4.0) < 1.0 && p.y < 4.0) discard;
  color = vec4(check(p), p.y, 1.0, 1.0);
}

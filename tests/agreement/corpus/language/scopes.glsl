// green
float x = 1.0;
float get() { return x; }
float shadow(float x) { { float x = x + 1.0; if (x > 0.0) { float x = x * 2.0; return x; } } return x; }
void mainImage(out vec4 color, in vec2 p) {
  float y = x;
  float x = 5.0;
  for (int x = 0; x < 3; ++x) y += float(x);
  { float x = get(); y += x; }
  bool ok = y == 5.0 && x == 5.0 && get() == 1.0 && shadow(2.0) == 6.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// green
#define length(v) (2.0 * length(v))
#define time (time + 1.0)
#define twice(x) x + x
float time_of() { return 3.0; }
void mainImage(out vec4 color, in vec2 p) {
#undef time
  float time = 2.0;
#define time (time + 1.0)
  bool ok = length(vec2(3.0, 4.0)) == 10.0 && time == 3.0 && (twice(time)) == 6.0 && time_of() == 3.0;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

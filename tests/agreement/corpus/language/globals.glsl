// green
int counter = 3;
vec2 place = vec2(1.0, 2.0);
float list[2] = float[2](0.5, 0.25);
void step_on() { counter *= 2; place = place.yx; list[counter & 1] += 1.0; }
int read_and_step() { int old = counter; step_on(); return old; }
void mainImage(out vec4 color, in vec2 p) {
  int a = read_and_step();
  int b = read_and_step();
  bool ok = a == 3 && b == 6 && counter == 12 && place == vec2(1.0, 2.0) && list[0] == 2.5 && list[1] == 0.25;
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

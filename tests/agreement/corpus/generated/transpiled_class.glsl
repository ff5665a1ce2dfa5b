// From an object language: methods take their object first.
struct Counter { int value; int limit; };
void Counter_init(inout Counter self_, int limit) { self_.value = 0; self_.limit = limit; }
bool Counter_tick(inout Counter self_) { self_.value = self_.value + 1; return self_.value >= self_.limit; }
int Counter_get(Counter self_) { return self_.value; }
struct Machine { Counter a; Counter b; };
void Machine_run(inout Machine self_, int steps) {
  for (int i = 0; i < steps; i = i + 1) {
    if (Counter_tick(self_.a)) { Counter_init(self_.a, 3); bool ignored = Counter_tick(self_.b); }
  }
}
void mainImage(out vec4 color, in vec2 p) {
  Machine m;
  Counter_init(m.a, 3);
  Counter_init(m.b, 100);
  Machine_run(m, int(p.x) / 4);
  color = vec4(float(Counter_get(m.a)) / 3.0, float(Counter_get(m.b)) / 11.0, step(p.y, 36.0), 1.0);
}

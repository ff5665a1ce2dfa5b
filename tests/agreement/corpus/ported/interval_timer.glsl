// From firmware: flags in a byte, and a table of durations.
#define FLAG_RED 0x01
#define FLAG_GREEN 0x02
#define FLAG_BLUE 0x04
const int durations[6] = int[6](12, 5, 9, 20, 3, 15);
const int flags[6] = int[6](FLAG_RED, FLAG_GREEN, FLAG_RED | FLAG_BLUE, 0, FLAG_GREEN | FLAG_BLUE, FLAG_RED | FLAG_GREEN);
int lookup(int t) { int i = 0; t %= 64; while (t >= durations[i]) { t -= durations[i]; i = (i + 1) % 6; } return flags[i]; }
void mainImage(out vec4 color, in vec2 p) {
  int f = lookup(int(p.x) + int(p.y) / 10);
  color = vec4((f & FLAG_RED) != 0, (f & FLAG_GREEN) != 0, (f & FLAG_BLUE) != 0, 1.0);
}

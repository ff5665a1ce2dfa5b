// Out of a C program: sorts what it then draws.
void swap(inout float a, inout float b) { float t = a; a = b; b = t; }
void sort(inout float list[6]) {
  for (int i = 0; i < 5; i++)
    for (int j = 0; j < 5 - i; j++)
      if (list[j] > list[j + 1]) swap(list[j], list[j + 1]);
}
void mainImage(out vec4 color, in vec2 p) {
  float list[6];
  for (int i = 0; i < 6; i++) list[i] = fract(float(i * 37 + int(p.y) / 12 * 17) / 23.0);
  sort(list);
  int k = min(int(p.x / iResolution.x * 6.0), 5);
  color = vec4(list[k], list[5 - k], list[(k * 5) % 6], 1.0);
}

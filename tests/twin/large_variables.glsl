// Arrays just below the 64 KB that browsers allow, several in one call chain, as results and as arguments.
struct Table { float entries[4000]; };
float shared_entries[16383];

Table filled(float start) {
  Table table;
  for (int i = 0; i < 4000; ++i) table.entries[i] = start + float(i);
  return table;
}

Table with(Table table, int index, float value) {
  table.entries[index] = value;
  return table;
}

float deepest(int n) {
  float a[16383];
  a[n] = 3.0;
  a[16382] = 4.0;
  return a[n] + a[16382];
}

float deeper(int n) {
  float a[16383];
  a[n + 1] = deepest(n);
  return a[n + 1] + deepest(n + 2);
}

void mainImage(out vec4 color, in vec2 position) {
  int n = int(position.x);
  vec3 b[5461];
  b[n] = vec3(deeper(n));
  b[5460] = vec3(1.0, 2.0, dFdx(position.x));
  shared_entries[n] = 5.0;
  Table table = with(with(with(filled(position.x), 1, 7.0), 2, 8.0), n + 3, 9.0);
  float sum = table.entries[1] + table.entries[2] + table.entries[n + 3] + table.entries[3999] - position.x;
  bool right = b[n] == vec3(14.0) && b[5460] == vec3(1.0, 2.0, 1.0) && shared_entries[n] == 5.0 && sum == 4023.0;
  color = right ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
}

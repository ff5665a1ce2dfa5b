// A kernel's ids and its flat index.
#define get_global_id(d) (int(gid[d]))
#define get_global_size(d) (int(iResolution[d]))
vec2 gid;
float buffer_at(int index) { return float((index * 40503) & 255) / 255.0; }
void mainImage(out vec4 color, in vec2 p) {
  gid = p;
  int x = get_global_id(0), y = get_global_id(1), w = get_global_size(0);
  int i = y / 4 * w + x / 4;
  float v = buffer_at(i);
  v = max(v, buffer_at(i + 1));
  v = min(v, buffer_at(i + w));
  color = vec4(v, buffer_at(i), 0.5, 1.0);
}

const int perm[16] = int[16](7, 12, 3, 9, 0, 14, 5, 10, 1, 15, 6, 11, 2, 8, 13, 4);
int hash(int x, int y) { return perm[(perm[(perm[x & 15] + y) & 15] + (x >> 4)) & 15]; }
void mainImage(out vec4 color, in vec2 p) { int h = hash(int(p.x) / 2, int(p.y) / 2); color = vec4(float(h) / 15.0, float(h & 3) / 3.0, h > 7, 1.0); }

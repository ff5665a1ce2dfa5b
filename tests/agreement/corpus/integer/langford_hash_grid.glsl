ivec2 shuffle(ivec2 q) { for (int i = 0; i < 3; ++i) { q.x = (q.x * 5 + q.y * 3 + 1) & 63; q.y = (q.y * 9 + (q.x >> 1) + 7) & 63; q = q.yx; } return q; }
void mainImage(out vec4 color, in vec2 p) { ivec2 s = shuffle(ivec2(p) / 2); color = vec4(vec2(s) / 63.0, float((s.x ^ s.y) & 31) / 31.0, 1.0); }

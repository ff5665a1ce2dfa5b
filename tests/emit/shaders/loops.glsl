// Every loop; what is declared where; continue and break.
void mainImage(out vec4 color, in vec2 p) {
  float a = 0.0, b = 0.0, prev;
  for (int i = 0, j = 10; i < j; i++, j--) { if (i == 2) continue; a += float(i * j); }
  int k = int(p.x) % 5;
  while (true) { if (k++ > 8) break; b += 1.0; }
  do { b += 0.25; k -= 2; } while (k > 0);
  for (;;) { if (b > 30.0) break; b *= 2.0; }
  float sum = 0.0;
  for (int i = 0; i < 4; i++) { float cur = float(i) + p.y; if (i > 0) sum += cur * prev; prev = cur; }
  float fresh = 0.0;
  for (int i = 0; i < 4; i++) { float once = 1.0; once += float(i); fresh += once; { float once = 2.0; fresh *= once; } }
  for (float t = 0.0; t < 1.0; t += 0.125) for (int i = 0; i < 2; i++) fresh += t;
  int n = 0, i = 3;
  for (i = 0; i < 6; ++i) if (i % 2 == 0) n += i; else n -= 1;
  for (int q = 7; q > 0; q >>= 1);
  for (; n < 20; n += 7) { int i = 4; a += float(i); }
  float later;
  if (p.x > 3.0) later = 2.0; else { later = 3.0; }
  color = vec4(a, b, sum, fresh + float(n) + float(i) + later);
}

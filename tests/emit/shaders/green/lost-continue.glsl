// green = right. A `continue` goes on with its loop, whatever is around it and whatever the loop ends with.
int single(int skipped) { int s = 0; for (int i = 0; i < 10; i++) { switch (i) { case 3: s += 7; break; default: s += i; continue; } s += skipped; break; } return s; }
int in_while(int at) { int s = 0, i = -1; while (++i < 10) { switch (i) { case 3: break; default: { s += i; continue; } } break; } return s; }
int in_do(int at) { int s = 0, i = 0; do { switch (i) { case 3: break; default: s += i; continue; } return s; } while (i++ < 10); return -1; }
int in_uint() { int s = 0; for (uint i = 0u; i < 10u; i++) { switch (i) { case 3u: break; default: s += int(i); continue; } break; } return s; }
int by_flag() { int s = 0; for (int i = 0; i < 10; i++) { bool on = false; if (i != 3) { s += i; on = true; } if (on) continue; break; } return s; }
int by_flag_in_else() { int s = 0; for (int i = 0; i < 10; i++) { bool on = false; if (i != 3) { s += i; on = true; } if (!on) break; else continue; } return s; }
int once() { int s = 0; for (int i = 0; i < 10; i++) { bool on = false; for (;;) { if (i == 3) break; s += i; on = true; break; } if (on) continue; { break; } } return s; }
int nested() {
  int s = 0;
  for (int i = 0; i < 10; i++) {
    switch (i) {
      case 3: break;
      default:
        switch (i & 1) { case 0: s += 10; continue; default: s += i; }
        continue;
    }
    break;
  }
  return s;
}
int nested_in_loop() {
  int s = 0;
  for (int i = 0; i < 4; i++)
    switch (i) {
      case 2: s += 1000; break;
      case 0:
        for (int j = 0; j < 5; j++) { switch (j) { case 3: break; default: s += j; continue; } break; }
      default: s += 100; if (i == 1) continue; s += 20; break;
    }
  return s;
}
int without_braces() { int s = 0; for (int i = 0; i < 10; i++) if (i < 4) { s += i; continue; } else break; return s; }
void mainImage(out vec4 o, vec2 p) {
  bool ok = single(100) == 110 && in_while(0) == 3 && in_do(0) == 3 && in_uint() == 3 && by_flag() == 3 && by_flag_in_else() == 3 &&
            once() == 3 && nested() == 21 && nested_in_loop() == 1343 && without_braces() == 6;
  o = vec4(ok ? 0. : 1., ok ? 1. : 0., 0., 1.);
}

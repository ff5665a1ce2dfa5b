// A little virtual machine: opcodes in an array, a switch that runs them.
const int program[8] = int[8](1, 3, 2, 4, 0, 1, 5, 2);
void mainImage(out vec4 color, in vec2 p) {
  ivec2 q = ivec2(p) / 4;
  int a = q.x, b = q.y, c = 1;
  for (int pc = 0; pc < 8; ++pc) {
    switch (program[(pc + q.x) & 7]) {
      case 0: a += b; break;
      case 1: b ^= a << 1;
      case 2: c += 3; break;
      case 3: { int t = a; a = b; b = t; break; }
      case 4: if (a > 9) continue; a -= 5; break;
      default: c = -c;
    }
    c &= 0xff;
  }
  color = vec4(ivec4(a, b, c, 255) & 255) / 255.0;
}

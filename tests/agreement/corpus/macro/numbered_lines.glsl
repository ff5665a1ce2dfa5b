// green
#define LINE __LINE__
#define VERSIONED (__VERSION__ == 300)
void mainImage(out vec4 color, in vec2 p) {
  int here = __LINE__;
  int next_one = LINE;
#if __VERSION__ >= 300 && defined GL_ES
  bool ok = next_one == here + 1 && VERSIONED;
#else
  bool ok = false;
#endif
  color = ok ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

// green
#define SUM(a, /* the second */ b) a /* plus */ + b // and no more
#define LONG 1 + /* over
two lines */ 2
/* #define SUM wrong */
void mainImage(out vec4 color, in vec2 p) {
  int x = SUM(1, /* a comma, */ 2);
  color = x == 3 && LONG == 3 ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1);
}

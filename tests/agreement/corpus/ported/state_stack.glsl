// Turtle graphics with a stack of matrices, as fixed function had it.
mat3 stack[4];
int top = 0;
void push() { stack[top + 1] = stack[top]; top++; }
void pop() { top--; }
void translate(float x, float y) { stack[top] = stack[top] * mat3(1, 0, 0, 0, 1, 0, x, y, 1); }
void scale(float k) { stack[top] = stack[top] * mat3(k, 0, 0, 0, k, 0, 0, 0, 1); }
float square(vec2 p) { vec3 q = inverse(stack[top]) * vec3(p, 1.0); return max(abs(q.x), abs(q.y)) < 0.5 ? 1.0 : 0.0; }
void mainImage(out vec4 color, in vec2 p) {
  stack[0] = mat3(1.0);
  translate(64.0, 36.0);
  scale(32.0);
  color = vec4(0.3 * square(p), 0.0, 0.0, 1.0);
  push(); translate(1.0, 0.5); scale(0.5); color.g += square(p); pop();
  push(); translate(-1.0, -0.25); scale(0.75); color.b += square(p);
  push(); translate(0.5, 0.5); scale(0.25); color.r += 0.7 * square(p); pop(); pop();
}

#define TWICE(x) ((x) * 2.0)
float add(float a, float b) { return a + b; }

// Overloaded functions, prototypes, unnamed and const parameters, precision qualifiers.
precision highp float;
precision mediump int;
float f(float x); float f(vec2 v); float f(int i);
lowp float g(const in mediump float x, int unused) { return x + 1.0; }
float f(uint u) { return float(u) + 0.125; }
float f(int i) { return float(i) + 0.25; }
float f(float x) { return x + 0.5; }
float f(vec2 v) { return f(v.x) + f(v.y); }
float f(vec2 v, float w) { return f(v) * w; }
float f(mat2 m) { return m[0][0]; }
float f(float v[2]) { return v[0] - v[1]; }
bool f(bool b) { return !b; }
void nothing() {}
vec4 zero() { nothing(); return vec4(0); }
void mainImage(out highp vec4 color, in highp vec2 p) {
  color = zero() + vec4(f(p.x) + f(int(p.x)), f(p, 2.0), f(uint(p.y)) + f(mat2(p.x)), g(p.y, 3) + f(float[2](p.x, p.y)) + (f(p.x > 3.0) ? 1.0 : 0.0));
}

struct complex { float re, im; };
complex c_add(complex a, complex b) { return complex(a.re + b.re, a.im + b.im); }
complex c_mul(complex a, complex b) { return complex(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re); }
complex c_div(complex a, complex b) { float n = b.re * b.re + b.im * b.im; return complex((a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n); }
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (2.0 * p - iResolution.xy) / iResolution.y;
  complex z = complex(q.x, q.y), one = complex(1.0, 0.0);
  complex w = c_div(c_add(c_mul(z, z), complex(-1.0, 0.0)), c_add(c_mul(z, z), one));
  color = vec4(step(0.0, w.re), step(0.0, w.im), step(1.0, w.re * w.re + w.im * w.im), 1.0);
}

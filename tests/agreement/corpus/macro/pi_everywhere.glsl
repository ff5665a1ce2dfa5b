#define TAU (2. * PI)
#define PI 3.141592653589793
#define DEG(x) ((x) * TAU / 360.)
#define POLAR(a, r) (vec2(cos(DEG(a)), sin(DEG(a))) * (r))
void mainImage(out vec4 color, in vec2 p) {
  vec2 q = (p - .5 * iResolution.xy) / iResolution.y;
  color = vec4(0, 0, 0, 1);
  for (float a = 0.; a < 360.; a += 45.) color.rgb += step(length(q - POLAR(a + 10., .35)), .06) * vec3(1, a / 360., .4);
}

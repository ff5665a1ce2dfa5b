// Functions that a C++ test calls: no entry point, a global, a structure, a constant array, discard.
struct Sphere { vec3 center; float radius; };

const float weights[3] = float[](0.25, 0.5, 0.25);
uint seed = 1u;

uint random() {
  seed = seed * 747796405u + 2891336453u;
  return seed;
}

float schlick(float c, float n) {
  float r = (1.0 - n) / (1.0 + n);
  float m = clamp(1.0 - c, 0.0, 1.0), m2 = m * m;
  r *= r;
  return r + (1.0 - r) * m2 * m2 * m;
}

bool hit(Sphere s, vec3 o, vec3 d, inout float t) {
  vec3 oc = o - s.center;
  float b = dot(oc, d), q = b * b - dot(oc, oc) + s.radius * s.radius;
  if (q < 0.0) return false;
  t = -b - sqrt(q);
  return true;
}

float blurred(float v[3]) {
  float sum, unset;
  for (int i = 0; i < 3; i++) sum += weights[i] * v[i];
  return sum + unset;
}

float in_time(float x) {
  if (x < 0.0) discard;
  return x * iTime;
}

float with_library_names(float x) { return abs(x) + sqrt(abs(x)) + floor(x) + pow(abs(x), 3.0) + round(x); }

float normal_reflectance() {
  float r = (INDEX - 1.0) / (INDEX + 1.0);
  return r * r;
}
vec3 bounced(vec3 d, vec3 n) { return reflect(d, n); }

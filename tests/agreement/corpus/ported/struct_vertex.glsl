// An engine's surface shader: its structures filled by hand.
struct Input { vec2 uv; vec3 normal; vec3 view; };
struct Output { vec3 albedo; float gloss; float specular; };
void surface(in Input i, inout Output o) {
  o.albedo = vec3(step(0.5, fract(i.uv * 6.0)), 0.4);
  o.gloss = 0.2 + 0.6 * i.uv.x;
  o.specular = i.uv.y;
}
vec3 light(Output s, Input i, vec3 direction) {
  float diffuse = max(dot(i.normal, direction), 0.0);
  vec3 half_way = (direction + i.view) / length(direction + i.view);
  float shine = pow(max(dot(i.normal, half_way), 0.0), 1.0 + 32.0 * s.gloss);
  return s.albedo * diffuse + s.specular * shine;
}
void mainImage(out vec4 color, in vec2 p) {
  Input i;
  i.uv = p / iResolution.xy;
  vec2 d = 2.0 * i.uv - 1.0;
  i.normal = vec3(d, sqrt(max(1.0 - dot(d, d), 0.01)));
  i.view = vec3(0.0, 0.0, 1.0);
  Output o = Output(vec3(0.0), 0.0, 0.0);
  surface(i, o);
  color = vec4(light(o, i, vec3(0.48, 0.6, 0.64)), 1.0);
}

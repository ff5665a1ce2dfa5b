// A display list drawn from back to front.
struct Command { int kind; vec4 box; vec3 color; };
const Command list[4] = Command[4](Command(0, vec4(0.1, 0.1, 0.8, 0.8), vec3(0.2, 0.3, 0.6)), Command(1, vec4(0.3, 0.4, 0.3, 0.4), vec3(0.9, 0.8, 0.2)),
                                   Command(0, vec4(0.55, 0.2, 0.3, 0.2), vec3(0.8, 0.2, 0.2)), Command(2, vec4(0.2, 0.6, 0.6, 0.3), vec3(0.1, 0.7, 0.4)));
bool covers(Command c, vec2 uv) {
  vec2 q = (uv - c.box.xy) / c.box.zw;
  switch (c.kind) {
    case 0: return q.x >= 0.0 && q.x <= 1.0 && q.y >= 0.0 && q.y <= 1.0;
    case 1: q = 2.0 * q - 1.0; return dot(q, q) < 1.0;
    default: return q.y >= 0.0 && q.y <= 1.0 && abs(q.x - 0.5) <= 0.5 * (1.0 - q.y);
  }
}
void mainImage(out vec4 color, in vec2 p) {
  color = vec4(1.0);
  for (int i = 0; i < list.length(); ++i) if (covers(list[i], p / iResolution.xy)) color.rgb = list[i].color;
}

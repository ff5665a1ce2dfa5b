// State of a game in single texels, each at its address.
const ivec2 at_ball = ivec2(0, 0), at_speed = ivec2(1, 0), at_score = ivec2(2, 0);
vec4 load(ivec2 at) { return texelFetch(iChannel0, at, 0); }
void store(ivec2 at, vec4 value, inout vec4 color, ivec2 p) { if (p == at) color = value; }
void mainImage(out vec4 color, in vec2 position) {
  ivec2 p = ivec2(position);
  if (p.x > 3 || p.y > 0) discard;
  vec4 ball = load(at_ball), speed = load(at_speed), score = load(at_score);
  if (iFrame == 0) {
    ball = vec4(0.25, 0.5, 0.0, 0.0);
    speed = vec4(0.125, 0.3125, 0.0, 0.0);
    score = vec4(0.0);
  }
  ball.xy += speed.xy;
  if (ball.x < 0.0 || ball.x > 1.0) { speed.x = -speed.x; score.x += 1.0; }
  if (ball.y < 0.0 || ball.y > 1.0) { speed.y = -speed.y; score.y += 1.0; }
  color = vec4(0.0);
  store(at_ball, ball, color, p);
  store(at_speed, speed, color, p);
  store(at_score, score, color, p);
}

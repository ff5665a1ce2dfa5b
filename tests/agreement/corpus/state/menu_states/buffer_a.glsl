// start -> play -> pause -> play -> over, a tick each, with what is carried along.
#define START 0
#define PLAY 1
#define PAUSE 2
#define OVER 3
int next(int state, int ticks) {
  switch (state) {
    case START: return PLAY;
    case PLAY: return ticks % 2 == 1 ? PAUSE : ticks > 3 ? OVER : PLAY;
    case PAUSE: return PLAY;
  }
  return state;
}
void mainImage(out vec4 color, in vec2 p) {
  if (ivec2(p) != ivec2(0)) { color = vec4(0.0); return; }
  vec4 old = texelFetch(iChannel0, ivec2(0), 0);
  if (iFrame == 0) old = vec4(START, 0, 0, 0);
  int state = next(int(old.x), int(old.y));
  color = vec4(state, old.y + 1.0, old.z + (state == PLAY ? 10.0 : 0.0), 1.0);
}

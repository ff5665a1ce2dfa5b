// From a Processing sketch: a canvas of 400 by 300 with y down.
const float w = 400.0, h = 300.0;
float dist_to(vec2 a, float x, float y) { return distance(a, vec2(x, y)); }
void mainImage(out vec4 fragColor, vec2 fragCoord) {
  vec2 pos = vec2(fragCoord.x / iResolution.x * w, h - fragCoord.y / iResolution.y * h);
  vec3 bg = vec3(240.0, 236.0, 220.0) / 255.0;
  for (int row = 0; row < 5; row++) {
    for (int col = 0; col < 7; col++) {
      float x = 30.0 + float(col) * 55.0, y = 30.0 + float(row) * 60.0;
      float r = 10.0 + 3.0 * float((row * 7 + col) % 4);
      if (dist_to(pos, x, y) < r) bg = vec3(float(row) / 4.0, 0.3, float(col) / 6.0);
    }
  }
  fragColor = vec4(bg, 1.0);
}

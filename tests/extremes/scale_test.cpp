// Whole pictures of a scene that is far smaller, larger or farther from the origin than floats like.
#include <cmath>

#include "tests/shadertoy/bar.h"

namespace shadertwin {
namespace {

class Scale : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Scale);

Take stage(std::vector<std::pair<std::string, std::string>> defines) {
  return {.file = "stage_image.glsl", .width = 48, .height = 27, .frames = 1, .defines = std::move(defines)};
}

TEST_P(Scale, A) {
  const Image one = play(stage({}));
  const Image dbl = run_shader(backends()[2], stage({}));
  auto cmp = [&](const char* what, const Image& a, const Image& b) {
    std::size_t diff = 0;
    double e = 0, mb = 0, ma = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
      diff += a.rgba[i] != b.rgba[i];
      if (i % 4 != 3) {
        e += std::pow(a.rgba[i] - b.rgba[i], 2) / (std::pow(b.rgba[i], 2) + 0.01);
        ma += a.rgba[i];
        mb += b.rgba[i];
      }
    }
    std::printf("%s: %zu of %zu, relmse %g, means %g %g\n", what, diff, a.rgba.size(), e / a.rgba.size(),
                ma / mb - 1, ma);
  };
  cmp("one dbl", one, dbl);
  cmp("2^-13", play(stage({{"SCALE", "0.0001220703125"}})), one);
  cmp("2^13", play(stage({{"SCALE", "8192.0"}})), one);
  cmp("2^-13 dbl", run_shader(backends()[2], stage({{"SCALE", "0.0001220703125"}})), one);
  for (const char* m : {"vec3(1.0e3)", "vec3(1.0e4, 0.0, 0.0)", "vec3(1.0e5, 0.0, 0.0)",
                        "vec3(0.0, 1.0e5, 0.0)", "vec3(-1.0e5, 1.0e5, 1.0e5)"}) {
    cmp(m, play(stage({{"MOVE", m}})), run_shader(backends()[2], stage({{"MOVE", m}})));
    cmp(m, run_shader(backends()[2], stage({{"MOVE", m}})), dbl);
  }
}

}  // namespace
}  // namespace shadertwin

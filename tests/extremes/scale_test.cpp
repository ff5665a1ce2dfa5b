// Pictures of a scene that is far smaller, larger or farther from the origin than floats like.
#include <cmath>
#include <string>

#include "host/compare/errors.h"
#include "tests/shadertoy/bar.h"

namespace shadertwin::scale_test {
namespace {

class Scale : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Scale);

Take stage(std::vector<std::pair<std::string, std::string>> defines) {
  return {.file = "stage_image.glsl", .width = 48, .height = 27, .defines = std::move(defines)};
}

// Every operation of a path tracer keeps a factor of all lengths, and a power of two rounds nothing. Any
// length that is written down in the shader, such as a least distance, breaks this.
TEST_P(Scale, ScenesTimesAPowerOfTwoGiveTheSameBits) {
  const Image expected = play(stage({}));
  for (const char* scale : {"0.0001220703125", "8192.0"}) {
    // A twin takes seconds to compile.
    if (GetParam() == "cpu" && scale[0] != '8') continue;
    const Image got = play(stage({{"SCALE", scale}}));
    Bar bar("stage times " + std::string(scale));
    for (std::size_t i = 0; i < got.rgba.size(); ++i)
      bar.holds(got.rgba[i] == expected.rgba[i], got.rgba[i], expected.rgba[i], {{"number", i}});
  }
}

// Floats are 2^-14 and 2^-7 apart there: the balls, of radius 0.5 to 1, are 64 to 128 of the latter large.
// The same random numbers make the same picture, but for paths that rounding sends past another edge: as many
// as floats are far apart.
TEST_P(Scale, ScenesFarFromTheOriginLookTheSame) {
  struct Place {
    const char* move;
    double mean, relative_mse;
  };
  const Image expected = run_shader(backends().back(), stage({}));
  for (const Place& place :
       {Place{"vec3(1.0e3)", 1e-4, 1e-2 / 128.0}, Place{"vec3(-1.0e5, 1.0e5, 1.0e5)", 1e-2, 1e-2}}) {
    if (GetParam() == "cpu" && place.mean < 1e-3) continue;
    const Image got = play(stage({{"MOVE", place.move}}));
    Bar finite("stage at " + std::string(place.move) + ", values that are no light");
    double sum = 0.0;
    double expected_sum = 0.0;
    for (std::size_t i = 0; i < got.rgba.size(); ++i) {
      const auto value = static_cast<double>(got.rgba[i]);
      const auto light = static_cast<double>(expected.rgba[i]);
      finite.holds(std::isfinite(value) && value >= 0.0, value, light, {{"number", i}});
      if (i % 4 == 3) {
        EXPECT_EQ(value, 16.0) << "samples that are no numbers";
        continue;
      }
      sum += value;
      expected_sum += light;
    }
    EXPECT_NEAR(sum / expected_sum, 1.0, place.mean) << place.move;
    EXPECT_LE(picture_error(got, expected).relative_mse, place.relative_mse) << place.move;
  }
}

}  // namespace
}  // namespace shadertwin::scale_test

// Pictures from one pixel to 8K.
#include <cmath>
#include <string>

#include "host/text/load.h"
#include "reference/twin/twin_device.h"
#include "tests/shadertoy/bar.h"

namespace shadertwin::size_test {
namespace {

class Size : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Size);

// Light everywhere, one sample a pixel, and that of double but for the few paths that rounding sends
// elsewhere.
void expect_light(const Image& got, const Image& exact, const std::string& what) {
  Bar light(what + ", values that are no light");
  Bar samples(what + ", samples that are no numbers");
  std::size_t apart = 0;
  for (std::size_t i = 0; i < got.rgba.size(); ++i) {
    const auto value = static_cast<double>(got.rgba[i]);
    const auto expected = static_cast<double>(exact.rgba[i]);
    light.holds(std::isfinite(value) && value >= 0.0 && value < 100.0, value, expected, {{"number", i}});
    if (i % 4 == 3) samples.near(value, 1.0, 0.0, {{"number", i}});
    if (std::abs(value - expected) > 1e-3 * std::max(expected, 0.01)) ++apart;
  }
  EXPECT_LE(apart, got.rgba.size() / 50) << what << ": numbers of " << got.rgba.size();
}

TEST_P(Size, FromOnePixelToTheSidesOfEightK) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {2, 1}, {3, 500}, {7680, 1}, {1, 4320}, {16384, 2}}) {
    const Take take{.file = "../../shadertoy/image.glsl",
                    .width = size.x,
                    .height = size.y,
                    .defines = {{"SCENE", "0"}},
                    .pass = "P3D_RT"};
    expect_light(play(take), run_shader(backends().back(), take),
                 std::to_string(size.x) + "x" + std::to_string(size.y));
  }
}

TEST(Tiles, CornersOfEightKHaveTheirLight) {
  LoadOptions loading;
  loading.settings.defines = {{"SAMPLES", "1"}};
  Project project = load_project(SHADERTWIN_SOURCE_DIR "/tests/shadertoy/stage_image.glsl", loading);
  // Only the last pass is drawn in part, and it reads none of the others.
  project.passes = {project.passes.back()};
  project.passes.front().inputs = {};
  for (const glm::ivec2 corner : {glm::ivec2(0, 4320 - 32), {7680 - 32, 4320 - 32}}) {
    std::vector<Image> tiles;
    for (const bool in_double : {false, true}) {
      twin::TwinOptions options;
      options.double_precision = in_double;
      options.region = twin::Rectangle{corner.x, corner.y, 32, 32};
      const auto player = twin::make_player(project, options);
      Frame frame;
      frame.width = 7680;
      frame.height = 4320;
      player->render(frame);
      const Image all = player->read(static_cast<int>(project.passes.size()) - 1);
      Image tile(32, 32);
      for (int y = 0; y < 32; ++y) std::copy_n(all.at(corner.x, corner.y + y), 4 * 32, tile.at(0, y));
      tiles.push_back(std::move(tile));
    }
    expect_light(tiles[0], tiles[1], "8K at " + std::to_string(corner.x) + ", " + std::to_string(corner.y));
  }
}

}  // namespace
}  // namespace shadertwin::size_test

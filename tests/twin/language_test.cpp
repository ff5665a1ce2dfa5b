// Every construct of the language: the twin and llvmpipe give the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "host/gl/gl_device.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "reference/twin/twin_device.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> shaders() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders"))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// How far the twin may be from llvmpipe, relative to the value. Zero, and so bit for bit, but where filtering
// weights are rounded differently or Mesa reorders sums of products.
float tolerance(const fs::path& shader) {
  const std::string name = shader.stem();
  return name == "implicit_lod" || name == "uv_tricks" || name == "golf" ? 1e-6F : 0.0F;
}

bool same_value(float a, float b, float relative) {
  if (a != a && b != b) return true;  // NaNs have many encodings that no shader can tell apart
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         std::abs(a - b) <= relative * std::abs(b);
}

void expect_same(const Image& twin, const Image& gl, float relative) {
  ASSERT_EQ(twin.rgba.size(), gl.rgba.size());
  int different = 0;
  for (int y = 0; y < gl.height; ++y) {
    for (int x = 0; x < gl.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        if (same_value(twin.at(x, y)[c], gl.at(x, y)[c], relative) || ++different > 4) continue;
        ADD_FAILURE() << "pixel " << x << ", " << y << " channel " << c << ": twin " << twin.at(x, y)[c]
                      << ", llvmpipe " << gl.at(x, y)[c];
      }
    }
  }
  EXPECT_EQ(different, 0) << "of " << gl.rgba.size() << " values";
}

class Language : public testing::TestWithParam<fs::path> {};

void expect_same_frames(const Project& project, float relative) {
  const auto twin = twin::make_player(project);
  const auto gl =
      gl::make_player(gl::open_context("llvmpipe"), project, {.dispatch = gl::Dispatch::fragment});
  Schedule schedule;
  schedule.width = 17;
  schedule.height = 9;
  FixedClock clock(schedule, host_rules(project));
  for (int i = 0; i < 2; ++i) {
    const Frame frame = clock.next();
    twin->render(frame);
    gl->render(frame);
    const int last = static_cast<int>(project.passes.size()) - 1;
    expect_same(twin->read(last), gl->read(last), relative);
  }
}

TEST_P(Language, TwinAndLlvmpipeGiveTheSameBits) {
  expect_same_frames(load_project(GetParam()), tolerance(GetParam()));
}

// One pixel at a time is what check and debug run.
TEST(Packets, GiveTheBitsOfSinglePixels) {
  for (const char* name : {"divergence", "derivatives", "implicit_lod", "discards"}) {
    SCOPED_TRACE(name);
    const Project project =
        load_project(fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders" / (name + std::string(".glsl")));
    twin::TwinOptions single;
    single.packets = false;
    const auto one = twin::make_player(project, single);
    const auto packets = twin::make_player(project);
    Schedule schedule;
    schedule.width = 17;
    schedule.height = 9;
    const Frame frame = FixedClock(schedule, host_rules(project)).next();
    one->render(frame);
    packets->render(frame);
    const int last = static_cast<int>(project.passes.size()) - 1;
    expect_same(packets->read(last), one->read(last), 0.0F);
  }
}

std::string shader_name(const testing::TestParamInfo<fs::path>& info) {
  return info.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(, Language, testing::ValuesIn(shaders()), shader_name);

// Sums of products in user code are what Mesa reorders otherwise.
TEST(PreciseText, MakesMesaKeepTheOrderOfEveryOperation) {
  const fs::path shader = fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders/uv_tricks.glsl";
  expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
}

TEST(PreciseText, TakesEveryConstruct) {
  for (const char* name : {"special_calls", "structs", "side_effects", "ternary"}) {
    SCOPED_TRACE(name);
    const fs::path shader =
        fs::path(SHADERTWIN_SOURCE_DIR) / "tests/emit/shaders" / (name + std::string(".glsl"));
    expect_same_frames(load_project(shader, {.settings = {.precise = true}}), 0.0F);
  }
}

}  // namespace
}  // namespace shadertwin

// Whole pictures: pixels are boxes around their centres, specialised builds give the bits of general ones,
// and no knob of any scene gives a number that is none.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <regex>
#include <set>

#include "tests/shadertoy/bar.h"

namespace shadertwin::picture_test {
namespace {

class Pictures : public OnEveryBackend {};
SHADERTWIN_ON_FIRST_BACKEND(Pictures);
class Scenes : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Scenes);

using Defines = std::vector<std::pair<std::string, std::string>>;
constexpr const char* shader = "../../shadertoy/image.glsl";
constexpr int scenes = 5;

TEST_P(Pictures, PixelsAreBoxesAroundTheirCentres) {
  // The left half of the view shines: its edge runs between two columns.
  const Image image = play({.file = "room_image.glsl",
                            .width = 8,
                            .height = 4,
                            .frames = 64,
                            .defines = {{"ROOM", "4"}, {"ALBEDO", "0.0"}}});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      EXPECT_EQ(image.at(x, y)[0], x < 4 ? 1.0F : 0.0F) << "pixel " << x << ", " << y;
      EXPECT_EQ(image.at(x, y)[3], 64.0F);
    }
  // With an odd number of columns it runs through the middle one, which it halves.
  const Image odd = play({.file = "room_image.glsl",
                          .width = 7,
                          .height = 3,
                          .frames = 1024,
                          .defines = {{"ROOM", "4"}, {"ALBEDO", "0.0"}}});
  for (int y = 0; y < odd.height; ++y) {
    EXPECT_EQ(odd.at(2, y)[0], 1.0F);
    EXPECT_NEAR(odd.at(3, y)[0], 0.5F, 6.0 * 0.5 / 32.0);
    EXPECT_EQ(odd.at(4, y)[0], 0.0F);
  }
}

TEST_P(Pictures, SpecialisedAndGeneralBuildsGiveTheSameBits) {
  for (int scene = 0; scene < scenes; ++scene) {
    const Defines special = {{"SCENE", std::to_string(scene)}};
    Defines general = special;
    general.emplace_back("GENERAL", "1");
    Take take{.file = shader, .width = 24, .height = 14, .frames = 2, .defines = special, .pass = "P3D_RT"};
    const Image a = play(take);
    take.defines = general;
    const Image b = play(take);
    Bar bar("general against specialised build, scene " + std::to_string(scene));
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      bar.near(b.rgba[i], a.rgba[i], 0.0,
               {{"x", static_cast<double>(i / 4 % 24)},
                {"y", static_cast<double>(i / 96)},
                {"channel", static_cast<double>(i % 4)}});
  }
}

// The same paths, but for those that rounding sends to another side of an edge.
TEST_P(Pictures, TwoTrianglesAreTheParallelogram) {
  Take take{
      .file = shader, .width = 48, .height = 27, .frames = 1, .defines = {{"SCENE", "4"}}, .pass = "P3D_RT"};
  const Image quads = play(take);
  take.defines.emplace_back("QUAD_TEST", "1");
  const Image triangles = play(take);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < quads.rgba.size(); ++i)
    if (std::abs(triangles.rgba[i] - quads.rgba[i]) > 1e-3F * std::max(quads.rgba[i], 0.1F)) ++apart;
  EXPECT_LE(apart, quads.rgba.size() / 500) << "of " << quads.rgba.size() << " numbers";
}

TEST_P(Pictures, BuffersOfHalvesHoldHalves) {
  Take take{
      .file = shader, .width = 24, .height = 14, .frames = 3, .defines = {{"SCENE", "1"}}, .pass = "P3D_RT"};
  const Image full = play(take);
  take.defines.emplace_back("BUFFER_FORMAT", "1");
  const Image halves = play(take);
  Bar bar("buffer of half floats against one of floats");
  for (std::size_t i = 0; i < full.rgba.size(); ++i) {
    EXPECT_EQ(glm::unpackHalf1x16(glm::packHalf1x16(halves.rgba[i])), halves.rgba[i]);
    const auto value = static_cast<double>(full.rgba[i]);
    // Rounded after every frame; below 2^-14 halves are 2^-24 apart.
    bar.near(halves.rgba[i], value, 3.0 * std::max(0x1p-11 * value, 0x1p-24), {{"number", i}});
  }
  EXPECT_NE(full.rgba, halves.rgba);
}

// Every `#if NAME < low || NAME > high` of the shader is a knob.
std::vector<std::pair<std::string, int>> knobs() {
  std::vector<std::pair<std::string, int>> values;
  std::set<std::string> names;
  const std::regex range(R"(#if (\w+) < (\d+) \|\| \1 > (\d+))");
  for (const char* file : {"common.glsl", "P3D_RT.glsl", "image.glsl"}) {
    std::ifstream in(std::string(SHADERTWIN_SOURCE_DIR) + "/shadertoy/" + file);
    std::string line;
    while (std::getline(in, line)) {
      std::smatch match;
      if (!std::regex_match(line, match, range) || !names.insert(match[1]).second) continue;
      for (int value = std::stoi(match[2]); value <= std::stoi(match[3]); ++value)
        values.emplace_back(match[1], value);
    }
  }
  return values;
}

// Samples that were dropped because they are no numbers, and results that are none.
void expect_clean(const Image& image, int samples, const std::string& name) {
  double bad = 0.0;
  double dropped = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    for (std::size_t j = 0; j < 3; ++j)
      bad += std::isfinite(image.rgba[i + j]) && image.rgba[i + j] >= 0.0F ? 0.0 : 1.0;
    dropped += static_cast<double>(samples) - static_cast<double>(image.rgba[i + 3]);
  }
  EXPECT_EQ(bad, 0.0) << name;
  EXPECT_EQ(dropped, 0.0) << name << ": samples that are no numbers";
}

TEST_P(Scenes, EverySampleIsANumber) {
  for (int scene = 0; scene < scenes; ++scene)
    expect_clean(play({.file = shader,
                       .width = 32,
                       .height = 18,
                       .frames = 16,
                       .defines = {{"SCENE", std::to_string(scene)}},
                       .pass = "P3D_RT"}),
                 16, "scene " + std::to_string(scene));
}

// How many frames a soak takes: with SHADERTWIN_SOAK set, every scene plays that many with every value of
// every knob.
int soak_frames() {
  const char* text = std::getenv("SHADERTWIN_SOAK");
  return text ? std::atoi(text) : 0;
}

TEST_P(Pictures, EveryKnobsSamplesAreNumbers) {
  const auto all = knobs();
  ASSERT_GE(all.size(), 20U);
  const int soak = soak_frames();
  int turn = 0;
  for (const auto& [name, value] : all) {
    const int first = soak > 0 ? 0 : turn++ % scenes;
    for (int scene = first; scene < (soak > 0 ? scenes : first + 1); ++scene) {
      const int frames = soak > 0 ? soak : 8;
      const std::string what = "scene " + std::to_string(scene) + ", " + name + " " + std::to_string(value);
      const Image image = play({.file = shader,
                                .width = 32,
                                .height = 18,
                                .frames = frames,
                                .defines = {{"SCENE", std::to_string(scene)}, {name, std::to_string(value)}},
                                .pass = "P3D_RT"});
      expect_clean(image, frames, what);
      if (soak > 0)
        std::printf("%-48s %d frames%s\n", what.c_str(), frames,
                    HasFailure() ? "  a failure so far" : "  clean");
    }
  }
}

}  // namespace
}  // namespace shadertwin::picture_test

// `shadertwin compare` as a user types it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

class CompareCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("a.glsl",
                 "#iChannel0 \"self\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
                 "  c = texelFetch(iChannel0, ivec2(p), 0) * 1.3 + vec4(p, iTime, 1) / 7.;\n}\n");
    folder.write("main.glsl",
                 "#iChannel0 \"a.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
                 "  c = sqrt(texelFetch(iChannel0, ivec2(p), 0));\n}\n");
  }
  ScratchFolder folder;
};

// For each pixel of a heat map, whether it is not black.
std::vector<bool> coloured(const Image& map) {
  std::vector<bool> result;
  for (std::size_t i = 0; i < map.rgba.size(); i += 4)
    result.push_back(std::any_of(&map.rgba[i], &map.rgba[i] + 3, [](float value) { return value > 0.0F; }));
  return result;
}

TEST_F(CompareCommand, PreciseMakesLlvmpipeAndTheTwinAgree) {
  folder.write("sums.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  vec3 v = vec3(p / iResolution.xy, p.x / 7.);\n"
               "  c = vec4(v.x * v.z + v.y * v.x + v.z * v.y, (v.x + 0.1) + 0.1, v.xy);\n}\n");
  const std::string arguments = "compare sums.glsl --on llvmpipe --on cpu --size 32x18 --max-ulp 0";
  EXPECT_EQ(run(folder, arguments).status, 1);
  const Outcome outcome = run(folder, arguments + " --precise");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

// Both players miss it; the user has to read it once.
TEST_F(CompareCommand, WhatIsMissingIsToldOnce) {
  folder.write(
      "toy.json",
      R"({"Shader": {"renderpass": [{"type": "image", "outputs": [], "inputs": [{"id": 31, "ctype": "webcam",
               "channel": 0, "src": "/presets/webcam.png"}], "name": "",
               "code": "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }"}]}})");
  const Outcome outcome = run(folder, "compare toy.json --on llvmpipe --on cpu --size 4x3");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: "), std::string::npos);
}

TEST_F(CompareCommand, LlvmpipeAndOsmesaGiveTheSameBitsInEveryPass) {
  SHADERTWIN_NEEDS_OSMESA();
  const Outcome outcome =
      run(folder,
          "compare main.glsl --on llvmpipe --on osmesa --size 32x18 --frames 5 --every-frame "
          "--max-ulp 0 --min-equal 100 --json r.json --heatmap h.png");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("A: egl:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("B: osmesa"), std::string::npos) << outcome.out;
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  EXPECT_EQ(report["passes"].size(), 2U);
  EXPECT_EQ(report["passes"][0]["name"], "a");
  EXPECT_EQ(report["passes"][1]["channels"]["b"]["equal_percent"], 100.0);
  EXPECT_EQ(report["first_difference"], -1);
  const Image map = read_image(folder / "h.png");
  EXPECT_EQ(map.width, 32);
  EXPECT_EQ(map.height, 18);
  EXPECT_EQ(coloured(map), (std::vector<bool>(32 * 18, false)));
}

TEST_F(CompareCommand, PassLimitsTheComparison) {
  const Outcome outcome =
      run(folder, "compare main.glsl --on llvmpipe --on cpu --size 8x8 --pass a --json r.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(contents(folder / "r.json"))["passes"].size(), 1U);
}

TEST_F(CompareCommand, TwinGivesTheBitsOfLlvmpipe) {
  const Outcome outcome = run(
      folder, "compare main.glsl --on llvmpipe --on cpu --size 32x18 --frames 5 --max-ulp 0 --min-equal 100");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CompareCommand, ExitsWithOneBeyondTheLimitsAndSaysWhere) {
  const std::string command = "compare main.glsl --on cpu --on cpu/double --size 32x18 --frames 20 ";
  const Outcome within = run(folder, command + "--json r.json");
  EXPECT_EQ(within.status, 0) << within.err;
  EXPECT_NE(within.out.find("cpu/double"), std::string::npos) << within.out;
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  EXPECT_GT(report["passes"][0]["channels"]["r"]["ulp_max"], 0);
  EXPECT_LT(report["passes"][0]["channels"]["r"]["ulp_max"], 64);  // 20 roundings of a growing sum
  const Outcome beyond = run(folder, command + "--max-ulp 0");
  EXPECT_EQ(beyond.status, 1);
  EXPECT_EQ(beyond.error_lines(), 1) << beyond.err;
  EXPECT_EQ(run(folder, command + "--min-equal 100").status, 1);
}

TEST_F(CompareCommand, TheHeatMapIsColouredWhereTheLastPassDiffersAndOnlyThere) {
  const std::string frames = " --size 32x18 --frames 3 ";
  ASSERT_EQ(run(folder, "compare main.glsl --on cpu --on cpu/double" + frames + "--heatmap h.png").err, "");
  ASSERT_EQ(run(folder, "render main.glsl --on cpu" + frames + "-o float.exr").err, "");
  ASSERT_EQ(run(folder, "render main.glsl --on cpu/double" + frames + "-o double.exr").err, "");
  const Image a = read_image(folder / "float.exr");
  const Image b = read_image(folder / "double.exr");
  std::vector<bool> differs;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4)
    differs.push_back(!std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]));
  EXPECT_EQ(coloured(read_image(folder / "h.png")), differs);
  const auto apart = std::count(differs.begin(), differs.end(), true);
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, std::ssize(differs));
}

TEST_F(CompareCommand, NeedsTwoPlayers) {
  EXPECT_EQ(run(folder, "compare main.glsl").status, 2);
  EXPECT_EQ(run(folder, "compare main.glsl --on llvmpipe").status, 2);
  EXPECT_EQ(run(folder, "compare main.glsl --on llvmpipe --on llvmpipe --on llvmpipe").status, 2);
  EXPECT_EQ(run(folder, "compare main.glsl --on llvmpipe --on nothing").status, 2);
}

TEST_F(CompareCommand, RefusesLimitsThatMakeNoSense) {
  EXPECT_EQ(run(folder, "compare main.glsl --on llvmpipe --on llvmpipe --max-ulp -1").status, 2);
  EXPECT_EQ(run(folder, "compare main.glsl --on llvmpipe --on llvmpipe --min-equal 101").status, 2);
}

}  // namespace
}  // namespace shadertwin

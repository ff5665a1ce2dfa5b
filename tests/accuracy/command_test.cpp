// `shadertwin accuracy` as a user types it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

class AccuracyCommand : public testing::Test {
 protected:
  // An image shader whose third line is `statements`, at 8x4.
  Outcome judge(const std::string& statements, const std::string& options = "") {
    folder.write("a.glsl", "// a\nvoid mainImage(out vec4 c, in vec2 p) {\n" + statements + "\n}\n");
    return run(folder, "accuracy a.glsl --size 8x4 --frames 1 " + options);
  }
  void expect_refused(const std::string& arguments, int status, const std::string& text) {
    const Outcome outcome = run(folder, "accuracy " + arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  ScratchFolder folder;
};

TEST_F(AccuracyCommand, SaysWhatIsLostWhereAndHowMuchReachesThePicture) {
  const Outcome outcome = judge("c = vec4(((1.0 + p.x / 134217728.0) - 1.0) * 16777216.0);");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(
      outcome.out,
      "a.glsl:3: cancellation: all 24 bits lost in (1.0 + p.x / 134217728.0) - 1.0 (at worst, pixel 0,0 in "
      "frame 0: from 1 and 1 comes 0, exactly 3.7252903e-09); reaches the picture: off by up to 0.94 in 32 "
      "of "
      "32 pixels, the worst at pixel 7,0 in frame 0\n");
}

TEST_F(AccuracyCommand, NamesAProductOfConstantsWhole) {
  const std::string text =
      "float x = 3000.1 + p.x * 1e-4; c = vec4(x * x - 3000.1 * (1500.05 * 2.0) / 1.0 - x);";
  const Outcome outcome = judge(text, "--all");
  EXPECT_NE(outcome.out.find(" in x * x - 3000.1 * (1500.05 * 2.0) / 1.0 ("), std::string::npos)
      << outcome.out;
}

TEST_F(AccuracyCommand, IsSilentAboutOrdinaryRounding) {
  const Outcome outcome = judge("c = vec4(sin(p.x * 0.37) / 3.0, length(p) * 0.1, sqrt(p.y) - 0.7, 1.0);");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(AccuracyCommand, TellsLossesThatDoNotReachThePictureOnRequest) {
  const std::string text = "float d = (1.0 + p.x / 134217728.0) - 1.0; c = vec4(d);";
  EXPECT_EQ(judge(text).out, "");
  const std::string all = judge(text, "--all").out;
  EXPECT_EQ(all.find("a.glsl:3: cancellation: all 24 bits lost in"), 0U) << all;
  EXPECT_NE(all.find("; does not reach the picture\n"), std::string::npos) << all;
  EXPECT_NE(judge(text, "--threshold 1e-9").out.find("; reaches the picture"), std::string::npos);
}

TEST_F(AccuracyCommand, NeverAveragesNanIn) {
  // In float alone it is the root of a negative number.
  const Outcome outcome =
      judge("c = vec4(sqrt(((1.0 + p.x / 134217728.0) - 1.0) - 1e-10));", "--json r.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("a.glsl:3: cancellation: "), 0U) << outcome.out;
  EXPECT_NE(outcome.out.find(", and NaN in float or double alone in 32\n"), std::string::npos) << outcome.out;
  const nlohmann::json report = nlohmann::json::parse(contents(folder / "r.json"));
  EXPECT_EQ(report["picture"]["not_numbers"], 32);
  EXPECT_EQ(report["picture"]["mean_error"], 0.0);
  EXPECT_EQ(report["picture"]["pixels_over_threshold"], 32);
  for (const nlohmann::json& line : report["lines"])
    EXPECT_TRUE(std::isfinite(line["mean_relative_error"].get<double>())) << line;
}

TEST_F(AccuracyCommand, WritesEveryLineAndFindingAsJson) {
  judge("float y = p.x / 3.0;\nc = vec4(((1.0 + p.x / 134217728.0) - 1.0) * 16777216.0);", "--json r.json");
  const nlohmann::json report = nlohmann::json::parse(contents(folder / "r.json"));
  ASSERT_EQ(report["findings"].size(), 1U);
  const nlohmann::json& finding = report["findings"][0];
  EXPECT_EQ(finding["line"], 4);
  EXPECT_EQ(finding["kind"], "cancellation");
  EXPECT_EQ(finding["bits_lost"], 24.0);
  EXPECT_EQ(finding["result"]["float"], 0.0);
  EXPECT_EQ(finding["picture"]["pixels"], 32);
  ASSERT_EQ(report["lines"].size(), 2U);
  EXPECT_EQ(report["lines"][0]["line"], 3);
  EXPECT_EQ(report["lines"][0]["numbers"], 32);
  EXPECT_LE(report["lines"][0]["worst_relative_error"], 0x1p-24);
  EXPECT_EQ(report["lines"][1]["worst_relative_error"], 1.0);
  EXPECT_EQ(report["size"], (nlohmann::json{8, 4}));
}

TEST_F(AccuracyCommand, PaintsTheLogarithmOfTheError) {
  judge("c = vec4(p.x < 4.0 ? 0.5 : ((1.0 + p.x / 134217728.0) - 1.0) * 16777216.0);", "--heatmap h.exr");
  const Image heat = read_image(folder / "h.exr");
  ASSERT_EQ(heat.width, 8);
  EXPECT_EQ(heat.at(0, 0)[0] + heat.at(0, 0)[1] + heat.at(0, 0)[2], 0.0F);
  EXPECT_GT(heat.at(5, 0)[0], 0.85F);  // nearly 1: red
  EXPECT_LT(heat.at(5, 0)[2], 0.2F);
}

TEST_F(AccuracyCommand, TellsThePixelsStoryInOrder) {
  const Outcome outcome =
      judge("float d = (1.0 + p.x / 134217728.0) - 1.0;\nc = vec4(d * 16777216.0);", "--pixel 3,0");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto first =
      outcome.out.find("a.glsl:3: (1.0 + p.x / 134217728.0) - 1.0: from 1 (exactly 1.00000003), ");
  const auto second = outcome.out.find("\na.glsl:4: d * 16777216.0: ");
  const auto last = outcome.out.find("\npixel 3,0 of a in frame 0: 0 (exactly 0.4375)");
  EXPECT_EQ(first, 0U) << outcome.out;
  EXPECT_LT(first, second);
  EXPECT_LT(second, last);
  EXPECT_NE(last, std::string::npos) << outcome.out;
}

TEST_F(AccuracyCommand, FollowsErrorsThroughBuffersAndFrames) {
  folder.write("common.glsl", "// none\n");
  folder.write("a.glsl",
               "#iChannel0 \"file://b.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }\n");
  folder.write("b.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = vec4(((1.0 + p.x / 134217728.0) - 1.0) * 16777216.0);\n}\n");
  const Outcome outcome = run(folder, "accuracy a.glsl --size 8x4");
  EXPECT_NE(outcome.out.find("b.glsl:2: cancellation: "), std::string::npos) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("in 64 of 64 pixels"), std::string::npos) << outcome.out;
}

TEST_F(AccuracyCommand, FailsOnlyBeyondTheBar) {
  const std::string text = "c = vec4(((1.0 + p.x / 134217728.0) - 1.0) * 16777216.0);";
  EXPECT_EQ(judge(text, "--max-error 0.95").status, 0);
  const Outcome outcome = judge(text, "--max-error 0.1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(
      outcome.err,
      "shadertwin: a.glsl: the picture is off by 0.938 at pixel 7,0 in frame 0, more than --max-error\n");
}

TEST_F(AccuracyCommand, RefusesWhatItCannotHonour) {
  judge("c = vec4(1.0);");
  expect_refused("a.glsl --pass \"Buffer A\"", 2, "Buffer A");
  expect_refused("a.glsl --pixel 500,1", 2, "inside the 128x72 picture");
  expect_refused("a.glsl --threshold 2", 2, "--threshold 2: expected a number from 0 to 1");
  expect_refused("a.glsl --max-error many", 2, "expected a number from 0 to 1");
  expect_refused("a.glsl --media .", 2, "--media is for a Shadertoy JSON");
  expect_refused("a.glsl --heatmap h.doc", 2, "h.doc");
  expect_refused("a.glsl --pixel 1,1 --all", 2, "--all is of findings, and --pixel tells none");
  expect_refused("missing.glsl", 4, "missing.glsl");
  folder.write("sound/sound.glsl", "vec2 mainSound(int s, float t) { return vec2(sin(440.0 * t)); }\n");
  folder.write("sound/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
  expect_refused("sound --pass Sound", 2, "Sound is a sound");
  folder.write("broken.glsl", "void mainImage(out vec4 c, in vec2 p) { c = 1; }\n");
  EXPECT_EQ(run(folder, "accuracy broken.glsl").status, 3);
}

}  // namespace
}  // namespace shadertwin

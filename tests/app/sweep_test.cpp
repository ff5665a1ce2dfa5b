#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

// A sum that is cut off, and noise that a mean takes away; NaN and a refusal for those who ask.
constexpr const char* series = R"(
#ifndef TERMS
#define TERMS 8
#endif
void mainImage(out vec4 c, in vec2 p) {
  float x = p.x / iResolution.x, sum = 0.0, term = 1.0;
  for (int i = 1; i <= TERMS; i++) { sum += term; term *= x / float(i); }
#if TERMS == 1
  if (p.x < 1.0) sum = sqrt(-1.0 - iTime);
#elif TERMS == 3
  sum = undeclared;
#endif
  c = vec4(0.3 * sum);
}
)";

constexpr const char* noise = R"(
#iChannel0 "self"
#ifndef SEED
#define SEED 0
#endif
#ifndef OFFSET
#define OFFSET 0.0
#endif
float random(uvec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  v ^= v >> 16u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  return float(v.x >> 8u) / 16777216.0;
}
void mainImage(out vec4 c, in vec2 p) {
  vec4 last = iFrame == 0 ? vec4(0.0) : texelFetch(iChannel0, ivec2(p), 0);
  float x = 0.5 + random(uvec4(uvec2(p), iFrame, SEED)) + OFFSET;
  c = vec4(last.rgb + (x - last.rgb) / (last.a + 1.0), last.a + 1.0);
}
)";

struct Sweep : testing::Test {
  Sweep() {
    std::ofstream(folder / "series.glsl") << series;
    std::ofstream(folder / "noise.glsl") << noise;
  }
  // The report of a sweep that is to end with `status`.
  nlohmann::json sweep(const std::string& arguments, int status = 0) const {
    outcome = run(folder, "sweep " + arguments + " --json report.json");
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return fs::exists(folder / "report.json") ? nlohmann::json::parse(contents(folder / "report.json"))
                                              : nlohmann::json();
  }
  ScratchFolder folder;
  mutable Outcome outcome;
};

TEST_F(Sweep, MeasuresHowFarASettingIsFromTheTruth) {
  const auto points = sweep(
      "series.glsl -D TERMS=2,4,6 --reference TERMS=16 --size 64x4 --on cpu --runs 2 -o a.csv")["points"];
  ASSERT_EQ(points.size(), 3U);
  double last = 1.0;
  for (const auto& point : points) {
    // The first term that is left out, at x = 1, is the largest error.
    const double error = point["relative_mse"]["mean"];
    EXPECT_LT(error, last);
    EXPECT_GT(error, 0.0);
    EXPECT_EQ(point["relative_mse"]["standard_error"], 0.0);
    EXPECT_GT(point["milliseconds"], 0.0);
    last = error;
  }
  EXPECT_LT(last, 1e-6);
  const std::string csv = contents(folder / "a.csv");
  EXPECT_EQ(csv.rfind("TERMS,on,size,clock,runs,frames,milliseconds,", 0), 0U) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST_F(Sweep, TellsBiasFromNoiseByIndependentSeeds) {
  const auto points = sweep(
      "noise.glsl -D OFFSET=0.0,0.1 --size 64x64 --on cpu --frames 16 --reference-frames 256 --target "
      "1e-3,1e-4")["points"];
  ASSERT_EQ(points.size(), 2U);
  // A uniform number's variance is 1/12; the mean of the picture is 1.
  const double unit = 1.0 / 1.01;
  for (const auto& point : points) {
    EXPECT_NEAR(point["relative_variance"]["mean"], unit / 12 / 16, 2e-4);
    EXPECT_NEAR(point["slope"], -1.0, 0.1);
  }
  EXPECT_NEAR(points[0]["relative_bias2"]["mean"], 0.0, 2e-4);
  EXPECT_NEAR(points[1]["relative_bias2"]["mean"], 0.01 * unit, 1e-3);
  EXPECT_EQ(points[1]["time_to_target"][0]["seconds"], "never");
  EXPECT_TRUE(points[0]["time_to_target"][0]["seconds"].is_number());
  EXPECT_TRUE(points[0]["time_to_target"][0]["extrapolated"]);
  EXPECT_EQ(points[0]["convergence"].size(), 5U);
}

TEST_F(Sweep, DrawsOnUntilATargetIsReached) {
  const auto points = sweep(
      "noise.glsl -D OFFSET=0.0 --size 16x16 --on cpu --runs 1 --frames 4 --max-frames 256 --target 2e-3 "
      "--reference-frames 1024")["points"];
  EXPECT_EQ(points[0]["frames"], 64);  // 1/12 / 64 is the first below it
  EXPECT_FALSE(points[0]["time_to_target"][0]["extrapolated"]);
}

TEST_F(Sweep, VariesOneAtATimeAroundTheShadersOwnValues) {
  const auto points = sweep(
      "noise.glsl -D OFFSET=0.1,0.2 --init zero,raw --one-at-a-time --size 8x8 --on cpu --runs 1")["points"];
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0]["settings"]["OFFSET"], "0.0");
  EXPECT_EQ(points[3]["settings"]["init"], "raw");
  EXPECT_EQ(points[3]["settings"]["OFFSET"], "0.0");
}

TEST_F(Sweep, GivesEveryCaseAReferenceOfItsOwn) {
  const auto points = sweep(
      "noise.glsl --case OFFSET=0.0,5.0 --size 16x16,32x8 --on cpu --runs 1 --frames 4 --reference-frames 64")
      ["points"];
  ASSERT_EQ(points.size(), 4U);
  for (const auto& point : points) EXPECT_LT(point["relative_bias2"]["mean"], 5e-3) << point;
}

TEST_F(Sweep, TakesAPictureForTheTruth) {
  ASSERT_EQ(run(folder, "render series.glsl -D TERMS=16 --size 32x4 --on cpu -o truth.exr").status, 0);
  EXPECT_LT(
      sweep("series.glsl -D TERMS=12 --reference truth.exr --size 32x4 --on cpu --runs 1")["points"][0]
                                                                                          ["relative_mse"]
                                                                                          ["mean"],
      1e-12);
}

TEST_F(Sweep, RefusesAPictureOfAnotherSizeOnce) {
  ASSERT_EQ(run(folder, "render series.glsl --size 32x4 --on cpu -o truth.exr").status, 0);
  sweep("series.glsl -D TERMS=2,12 --reference truth.exr --size 16x4 --on cpu --runs 1 -o a.csv", 4);
  EXPECT_EQ(outcome.err, "shadertwin: truth.exr: has 32x4 pixels, the picture 16x4\n");
  EXPECT_FALSE(fs::exists(folder / "a.csv"));
}

TEST_F(Sweep, SaysThatTheReferenceFails) {
  sweep("series.glsl -D TERMS=1,2 --reference TERMS=3 --size 8x2 --on cpu --runs 1", 1);
  EXPECT_NE(outcome.err.find("TERMS=1: the reference: series.glsl:"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("no point could be played"), std::string::npos) << outcome.err;
}

TEST_F(Sweep, SeesAnErrorDirectiveInAPoint) {
  std::ofstream(folder / "refuses.glsl") << "#ifndef M\n#define M 0\n#endif\n#if M == 1\n#error one\n#endif\n"
                                            "void mainImage(out vec4 c, vec2 p) { c = vec4(0.5); }\n";
  const auto points = sweep("refuses.glsl -D M=0,1 --size 8x2 --on cpu --runs 1", 1)["points"];
  EXPECT_EQ(points[0]["status"], "ok");
  EXPECT_EQ(points[1]["status"], "refuses.glsl:5: error: #error one");
}

TEST_F(Sweep, GoesOnPastPointsThatFailAndCountsNaN) {
  const auto points =
      sweep("series.glsl -D TERMS=1,2,3 --reference TERMS=16 --size 8x2 --on cpu --runs 2", 1)["points"];
  EXPECT_EQ(points[0]["nan"], 2 * 2 * 3);  // rows, runs, channels
  EXPECT_TRUE(points[0]["relative_mse"]["mean"].is_number());
  EXPECT_EQ(points[1]["status"], "ok");
  EXPECT_NE(points[2]["status"].get<std::string>().find("undeclared"), std::string::npos);
  EXPECT_NE(outcome.err.find("1 of 3 points could not be played"), std::string::npos) << outcome.err;
}

TEST_F(Sweep, KeepsPicturesWithNaNOffTheFrontAndWarnsOfThemInTheReference) {
  const auto points =
      sweep("series.glsl -D TERMS=1,2 --reference TERMS=1 --size 8x2 --on cpu --runs 1")["points"];
  EXPECT_EQ(points[0]["relative_mse"]["mean"], 0.0);
  EXPECT_EQ(points[0]["pareto"], false);
  EXPECT_EQ(points[1]["pareto"], true);
  EXPECT_NE(outcome.err.find("the reference has 6 values that are NaN or infinite"), std::string::npos)
      << outcome.err;
}

TEST_F(Sweep, GoesOnFromItsLog) {
  const std::string command =
      "sweep noise.glsl -D OFFSET=0.0,0.1 --size 16x16 --on cpu --runs 2 --frames 4 --reference-frames 64 -o "
      "a.csv";
  ASSERT_EQ(run(folder, command).status, 0);
  const std::string log = contents(folder / "a.runs.csv");
  const std::string csv = contents(folder / "a.csv");
  // Broken off in the second run of the second point.
  std::ofstream(folder / "a.runs.csv") << log.substr(0, log.size() - 30);
  ASSERT_EQ(run(folder, command).status, 0);
  const std::string again = contents(folder / "a.runs.csv");
  // Without what broke off, the same lines; times are of their own runs.
  const std::size_t kept = log.substr(0, log.size() - 30).rfind('\n');
  EXPECT_EQ(again.substr(0, kept), log.substr(0, kept));
  EXPECT_EQ(std::count(again.begin(), again.end(), '\n'), std::count(log.begin(), log.end(), '\n') + 2);
  // What has been measured stays; another shader is measured anew.
  ASSERT_EQ(run(folder, command).status, 0);
  EXPECT_EQ(contents(folder / "a.runs.csv"), again);
  std::ofstream(folder / "noise.glsl", std::ios::app) << "// changed\nfloat unused() { return 1.0; }\n";
  ASSERT_EQ(run(folder, command).status, 0);
  EXPECT_GT(contents(folder / "a.runs.csv").size(), again.size());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

TEST_F(Sweep, PlotsErrorOverTime) {
  ASSERT_EQ(run(folder,
                "sweep series.glsl -D TERMS=2,4 --reference TERMS=16 --size 32x8 --on cpu --runs 1 --plot "
                "a.png --quiet")
                .status,
            0);
  const Image plot = read_image(folder / "a.png");
  EXPECT_GE(plot.width, 400);
  const Outcome without = run(folder,
                              "sweep series.glsl -D TERMS=2,4 --reference TERMS=16 --size 32x8 --on cpu "
                              "--runs 1 -o b.csv --plot b.png --quiet",
                              "PATH=/nowhere CXX=/usr/bin/c++");
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_NE(without.err.find("b.png: warning: no plot: gnuplot is not installed"), std::string::npos)
      << without.err;
  EXPECT_TRUE(fs::exists(folder / "b.csv"));
  EXPECT_FALSE(fs::exists(folder / "b.png"));
}

TEST_F(Sweep, RefusesWhatMeansNothing) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "a sweep of nothing"},
      {"-D TERM=1,2", "no pass mentions TERM; its knobs are TERMS=8"},
      {"-D TERMS=1,1", "1 is there twice"},
      {"-D TERMS=1,,2", "a value is empty"},
      {"-D TERMS=1,2 -D TERMS=3", "it is there twice"},
      {"-D SEED=1,2", "every run has a SEED of its own"},
      {"-D TERMS=1,2 --reference TRMS=3", "no pass mentions TRMS"},
      {"-D TERMS=1,2 --reference nothing.exr", "nothing.exr"},
      {"-D TERMS=1,2 --reference a.exr --reference-frames 3", "either a file or"},
      {"-D TERMS=1,2 --reference a.exr --size 8x8,9x9", "one picture"},
      {"-D TERMS=1,2 --target 1e-3", "needs a --reference"},
      {"-D TERMS=1,2 --reference TERMS=9 --target 1e-3", "--accumulates"},
      {"-D TERMS=1,2 --reference-frames 9 --max-frames 9", "--target"},
      {"-D TERMS=1,2 --plot a.png", "needs a --reference"},
      {"-D TERMS=1,2 --reference TERMS=9 --plot a.jpg", ".svg or a .png"},
      {"-D TERMS=1,2 -o a.json", "-o a.json: the table of points is a .csv"},
      {"-D TERMS=1,2 --runs 0", "--runs 0: expected a number of runs"},
      {"--on nowhere", "nowhere"},
      {"--init maybe", "expected zero or raw"},
      {"--size 8", "WIDTHxHEIGHT"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome refused = run(folder, "sweep series.glsl " + arguments);
    EXPECT_TRUE(refused.status == 2 || refused.status == 4) << arguments << refused.status;
    EXPECT_NE(refused.err.find(message), std::string::npos) << arguments << ": " << refused.err;
    EXPECT_EQ(refused.error_lines(), 1) << refused.err;
  }
}

}  // namespace
}  // namespace shadertwin

#include "host/sweep/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/base/error.h"
#include "host/sweep/report.h"
#include "tests/scratch_folder.h"

namespace shadertwin::sweep {
namespace {

// Noise that falls as 1 / frames beside a bias that stays, measured after 1, 2, 4 ... 64 frames of 10 ms.
std::vector<Measurement> runs(double bias2, double noise, int count = 1) {
  std::vector<Measurement> all;
  for (int run = 0; run < count; ++run)
    for (int frames = 1; frames <= 64; frames *= 2) {
      Measurement m;
      m.run = run;
      m.frames = frames;
      m.milliseconds = 10.0 + run;
      m.relative_bias2 = bias2;
      m.relative_variance = noise / frames;
      m.relative_mse = bias2 + noise / frames;
      m.mse = m.relative_mse;
      m.nan = 1;
      all.push_back(m);
    }
  return all;
}

TEST(Summary, IsOfTheLastMeasurement) {
  const Summary s = summarise(runs(0.0, 6.4, 3), {});
  EXPECT_EQ(s.runs, 3);
  EXPECT_EQ(s.frames, 64);
  EXPECT_EQ(s.milliseconds, 11.0);
  EXPECT_EQ(s.milliseconds_low, 10.0);
  EXPECT_EQ(s.milliseconds_high, 12.0);
  EXPECT_NEAR(s.relative_mse.mean, 0.1, 1e-12);
  EXPECT_NEAR(s.relative_mse.error, 0.0, 1e-12);
  EXPECT_NEAR(s.slope, -1.0, 1e-12);
  EXPECT_NEAR(s.efficiency, 1.0 / (0.1 * 0.704), 1e-9);
  EXPECT_EQ(s.nan, 3U);
}

TEST(Summary, HasTheStandardErrorOfSeveralRuns) {
  std::vector<Measurement> all(2);
  all[0].relative_mse = 1.0;
  all[1].relative_mse = 3.0;
  all[1].run = 1;
  const Summary s = summarise(all, {});
  EXPECT_EQ(s.relative_mse.mean, 2.0);
  EXPECT_NEAR(s.relative_mse.error, 1.0, 1e-12);  // sqrt(2) / sqrt(2)
  EXPECT_TRUE(std::isnan(summarise({all[0]}, {}).relative_mse.error));
}

TEST(TimeToTarget, IsMeasuredWhereThePictureGotThere) {
  const Summary s = summarise(runs(0.0, 6.4), {0.2, 0.15});
  EXPECT_NEAR(s.targets[0].seconds, 0.32, 1e-9);
  EXPECT_FALSE(s.targets[0].extrapolated);
  EXPECT_NEAR(s.targets[1].seconds, 6.4 / 0.15 * 0.01, 1e-6);  // between the frames that were measured
}

TEST(TimeToTarget, IsExtrapolatedByTheSlopeOfTheNoise) {
  const Summary s = summarise(runs(0.005, 6.4), {0.01});
  EXPECT_TRUE(s.targets[0].extrapolated);
  EXPECT_NEAR(s.targets[0].seconds, 6.4 / 0.005 * 0.01, 1e-6);
}

TEST(TimeToTarget, IsNeverWhereTheBiasIsLarger) {
  EXPECT_TRUE(std::isinf(summarise(runs(0.02, 6.4, 2), {0.01}).targets[0].seconds));
}

TEST(TimeToTarget, IsUnknownWhereOneRunCannotTellABiasFromNoise) {
  EXPECT_TRUE(std::isnan(summarise(runs(0.02, 6.4), {0.01}).targets[0].seconds));
}

TEST(Summary, OfNothingIsUnknown) {
  const Summary s = summarise({}, {0.1});
  EXPECT_TRUE(std::isnan(s.milliseconds));
  EXPECT_TRUE(std::isnan(s.relative_mse.mean));
}

Summary at(double milliseconds, double error) {
  Summary s;
  s.frames = 1;
  s.milliseconds = milliseconds;
  s.relative_mse.mean = error;
  return s;
}

using Front = std::vector<std::vector<bool>>;

TEST(ParetoFront, HoldsWhatNothingBeats) {
  const auto front =
      pareto_front({{at(1, 0.5)}, {at(2, 0.2)}, {at(2, 0.3)}, {at(3, 0.2)}, {at(4, 0.1)}, {at(1, unknown)}});
  EXPECT_EQ(front, Front({{true}, {true}, {false}, {false}, {true}, {false}}));
}

TEST(ParetoFront, HoldsNothingWithNaNOrInfinity) {
  Summary nan = at(1, 0.0);
  nan.nan = 1;
  Summary infinite = at(1, 0.1);
  infinite.infinite = 1;
  EXPECT_EQ(pareto_front({{nan}, {infinite}, {at(2, 0.2)}}), Front({{false}, {false}, {true}}));
}

TEST(ParetoFront, ComparesPicturesThatTookAsLongNotAsManyFrames) {
  EXPECT_EQ(pareto_front({{at(1, 0.5), at(2, 0.3), at(4, 0.2)}, {at(2, 0.1), at(4, 0.05)}, {at(5, 0.06)}}),
            Front({{true, false, false}, {true, true}, {false}}));
}

Report report() {
  Report r{.axes = {{Axis::Kind::define, "STEPS", {"8", "16"}, false}},
           .results = {},
           .devices = {"llvmpipe"},
           .has_reference = true};
  r.results.push_back({.point = {"8"},
                       .failed = "",
                       .summary = summarise(runs(0.02, 6.4, 2), {0.01}),
                       .curve = curve(runs(0.02, 6.4, 2))});
  r.results.push_back({.point = {"16"}, .failed = "a.glsl:1: error: \"x\", no", .summary = {}, .curve = {}});
  for (Summary& stage : r.results.front().curve) stage.nan = 0;
  find_pareto_fronts(r);
  return r;
}

TEST(Summary, OfAnExactPictureHasNoEfficiency) {
  EXPECT_GT(summarise(runs(0.02, 6.4, 2), {}).efficiency, 0.0);
  EXPECT_TRUE(std::isnan(summarise(runs(0.0, 0.0, 2), {}).efficiency));
}

TEST(Report, TableHasALineForEachPoint) {
  const std::string text = table(report());
  EXPECT_NE(text.find("* STEPS=8"), std::string::npos) << text;
  EXPECT_NE(text.find("never"), std::string::npos) << text;
  EXPECT_NE(text.find("STEPS=16: a.glsl:1: error"), std::string::npos) << text;
}

TEST(Report, JsonHoldsNoNaN) {
  const nlohmann::json json = to_json(report());
  EXPECT_EQ(json["points"][0]["settings"]["STEPS"], "8");
  EXPECT_EQ(json["points"][0]["time_to_target"][0]["seconds"], "never");
  EXPECT_EQ(json["points"][0]["flip"]["mean"], nullptr);
  EXPECT_EQ(json["points"][1]["status"], "a.glsl:1: error: \"x\", no");
}

TEST(Report, PlotsOnlyWhatGnuplotDraws) {
  EXPECT_THROW(need_plot_format("a.jpg"), Error);
  need_plot_format("a.SVG");
  need_plot_format("a.png");
}

}  // namespace
}  // namespace shadertwin::sweep

#include "host/sweep/steady_times.h"

#include <gtest/gtest.h>

#include "host/sweep/measurement.h"

namespace shadertwin::sweep {
namespace {

// Frames until the times are steady, at most a thousand.
template <typename TimeOf>
std::pair<int, double> settle(const TimeOf& time_of) {
  SteadyTimes times;
  int frames = 0;
  while (!times.steady() && frames < 1000) times.add(time_of(frames++));
  return {frames, median(times.last())};
}

TEST(SteadyTimes, AreThoseOfTwoBlocksThatAgree) {
  const auto [frames, time] = settle([](int) { return 3.0; });
  EXPECT_EQ(frames, 32);
  EXPECT_EQ(time, 3.0);
}

TEST(SteadyTimes, LeaveOutWhatWasSlowAtFirst) {
  // A driver that has a better program after 100 frames, and one that gets faster by the frame.
  const auto better = settle([](int frame) { return frame < 100 ? 2.0 - 0.01 * frame : 0.5; });
  EXPECT_EQ(better.second, 0.5);
  const auto faster = settle([](int frame) { return 1.0 + 4.0 / (1.0 + 0.05 * frame); });
  EXPECT_LT(faster.second, 1.5);
}

TEST(SteadyTimes, ForgiveSingleSlowFrames) {
  EXPECT_EQ(settle([](int frame) { return frame % 5 == 0 ? 30.0 : 1.0; }).first, 32);
}

TEST(SteadyTimes, OfAFewFramesAreAllOfThem) {
  SteadyTimes times;
  EXPECT_FALSE(times.steady());
  EXPECT_TRUE(times.last().empty());
  times.add(1.0);
  times.add(3.0);
  EXPECT_FALSE(times.steady());
  EXPECT_EQ(times.last(), (std::vector{1.0, 3.0}));
}

}  // namespace
}  // namespace shadertwin::sweep

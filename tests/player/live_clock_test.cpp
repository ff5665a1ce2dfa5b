#include "host/player/live_clock.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

constexpr glm::ivec2 size(64, 36);

ClockReading at(double seconds) {
  ClockReading reading;
  reading.seconds = seconds;
  reading.date = {2025, 3, 14, 7200.25};
  return reading;
}

TEST(LiveClock, TimeRunsWithTheClockFromZero) {
  LiveClock clock({}, host_rules(Dialect::shadertoy));
  const Frame first = clock.next(at(100.0), size);
  EXPECT_EQ(first.index, 0);
  EXPECT_EQ(first.time, 0.0);
  EXPECT_EQ(first.time_delta, 1.0 / 60.0);
  EXPECT_EQ(first.frame_rate, 60.0);
  EXPECT_EQ(first.date, glm::vec4(2025, 2, 14, 7200.25F));
  EXPECT_EQ(glm::ivec2(first.width, first.height), size);
  const Frame second = clock.next(at(100.5), size);
  EXPECT_EQ(second.index, 1);
  EXPECT_EQ(second.time, 0.5);
  EXPECT_EQ(second.time_delta, 0.5);
}

TEST(LiveClock, PauseTakesNoTime) {
  LiveClock clock({}, host_rules(Dialect::shadertoy));
  clock.next(at(0.0), size);
  clock.next(at(1.0), size);
  clock.set_paused(true);
  EXPECT_FALSE(clock.due());
  clock.set_paused(false);
  EXPECT_TRUE(clock.due());
  const Frame resumed = clock.next(at(50.0), size);
  EXPECT_EQ(resumed.time, 1.0);
  EXPECT_EQ(resumed.time_delta, 1.0 / 60.0);
  EXPECT_EQ(clock.next(at(50.25), size).time, 1.25);
}

TEST(LiveClock, ForcedFrameWhilePausedCountsButStandsStill) {
  LiveClock clock({.paused = true}, host_rules(Dialect::shadertoy));
  EXPECT_TRUE(clock.due()) << "there is always a first picture";
  clock.next(at(0.0), size);
  EXPECT_FALSE(clock.due());
  clock.force();
  ASSERT_TRUE(clock.due());
  const Frame forced = clock.next(at(9.0), size);
  EXPECT_EQ(forced.index, 1);
  EXPECT_EQ(forced.time, 0.0);
  EXPECT_EQ(forced.time_delta, 1.0 / 60.0);
  EXPECT_FALSE(clock.due());
}

TEST(LiveClock, StepIsOneSixtiethAndPauses) {
  LiveClock clock({}, host_rules(Dialect::shadertoy));
  clock.next(at(0.0), size);
  clock.step();
  EXPECT_TRUE(clock.paused());
  const Frame frame = clock.next(at(77.0), size);
  EXPECT_EQ(frame.time, 1.0 / 60.0);
  EXPECT_EQ(frame.index, 1);
  EXPECT_FALSE(clock.due());
}

// What makes the window's screenshot the picture that `render` gives.
TEST(LiveClock, FixedRateGivesTheFramesOfFixedClock) {
  Schedule schedule;
  schedule.width = size.x;
  schedule.height = size.y;
  schedule.fps = 24.0;
  schedule.t0 = 2.0;
  FixedClock fixed(schedule, host_rules(Dialect::vscode));
  LiveClock live({.t0 = 2.0, .rate = 24.0, .date = Date(), .paused = true}, host_rules(Dialect::vscode));
  for (int i = 0; i < 100; ++i) {
    if (i > 0) live.step();
    const Frame a = fixed.next();
    const Frame b = live.next(at(i * 0.3), size);
    ASSERT_EQ(a.index, b.index);
    ASSERT_EQ(a.time, b.time);
    ASSERT_EQ(a.time_delta, b.time_delta);
    ASSERT_EQ(a.frame_rate, b.frame_rate);
    ASSERT_EQ(a.date, b.date);
    ASSERT_EQ(a.mouse, b.mouse);
    ASSERT_EQ(a.keyboard, b.keyboard);
  }
}

TEST(LiveClock, ResetGoesBackToTheFirstFrame) {
  LiveClock clock({.t0 = 5.0}, host_rules(Dialect::shadertoy));
  clock.next(at(0.0), size);
  clock.next(at(1.0), size);
  clock.keyboard().press(65);
  clock.reset();
  const Frame frame = clock.next(at(2.0), size);
  EXPECT_EQ(frame.index, 0);
  EXPECT_EQ(frame.time, 5.0);
  EXPECT_EQ(frame.time_delta, 1.0 / 60.0);
  EXPECT_EQ(frame.keyboard[512 + 65], 255) << "toggles survive";
}

TEST(LiveClock, ReloadGoesOnOnTheSiteAndRecountsInTheExtension) {
  for (const Dialect dialect : {Dialect::shadertoy, Dialect::vscode}) {
    LiveClock clock({}, host_rules(dialect));
    for (int i = 0; i < 4; ++i) clock.next(at(i), size);
    clock.restart_frames();
    const Frame frame = clock.next(at(4.0), size);
    EXPECT_EQ(frame.index, dialect == Dialect::shadertoy ? 4 : 0);
    EXPECT_EQ(frame.time, 4.0);
  }
}

TEST(LiveClock, RecordingGoesByFramesAndLeavesNoJump) {
  LiveClock clock({}, host_rules(Dialect::shadertoy));
  clock.next(at(0.0), size);
  clock.next(at(1.0), size);
  clock.set_recording(50.0);
  EXPECT_DOUBLE_EQ(clock.next(at(11.0), size).time, 1.02);
  EXPECT_DOUBLE_EQ(clock.next(at(21.0), size).time, 1.04);
  clock.set_recording(std::nullopt);
  EXPECT_DOUBLE_EQ(clock.next(at(31.0), size).time, 1.04);
  EXPECT_DOUBLE_EQ(clock.next(at(31.5), size).time, 1.54);
}

TEST(LiveClock, FrameRateIsAnAverageOverHalfASecond) {
  LiveClock clock({}, host_rules(Dialect::shadertoy));
  Frame frame;
  for (int i = 0; i <= 5; ++i) {
    frame = clock.next(at(i * 0.1), size);
    EXPECT_EQ(frame.frame_rate, 60.0) << i;
  }
  frame = clock.next(at(0.6), size);
  EXPECT_NEAR(frame.frame_rate, 10.0, 1e-9);
}

TEST(LiveClock, ButtonsAndMouseReachTheFrame) {
  LiveClock clock({}, host_rules(Dialect::vscode));
  clock.mouse().press({3.0, 4.0}, size);
  clock.set_button(1, true);
  Frame frame = clock.next(at(0.0), size);
  EXPECT_EQ(frame.mouse, glm::vec4(3, 4, 3, 4));
  EXPECT_EQ(frame.mouse_button, glm::vec4(0, 1, 0, 0));
  clock.mouse().release();
  clock.set_button(1, false);
  frame = clock.next(at(1.0), size);
  EXPECT_EQ(frame.mouse, glm::vec4(3, 4, -3, -4));
  EXPECT_EQ(frame.mouse_button, glm::vec4(0));
}

TEST(LiveClock, SaysThatNoTimePassedWhilePausedWithTheExtensionsQuirks) {
  LiveClock clock({}, host_rules(Dialect::vscode, true));
  EXPECT_EQ(clock.next(at(1.0), size).time_delta, 0.0);
  EXPECT_EQ(clock.next(at(1.25), size).time_delta, 0.25);
  clock.set_paused(true);
  clock.force();
  EXPECT_EQ(clock.next(at(1.5), size).time_delta, 0.0);
}

}  // namespace
}  // namespace shadertwin

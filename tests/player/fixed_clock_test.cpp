#include "host/player/fixed_clock.h"

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace shadertwin {
namespace {

TEST(FixedClock, StartsWithTheExtensionsTimeDeltaWhenAsked) {
  Schedule schedule;
  FixedClock clock(schedule, host_rules(Dialect::vscode, true));
  EXPECT_EQ(clock.next().time_delta, 0.0);
  EXPECT_EQ(clock.next().time_delta, 1.0 / 60.0);
  EXPECT_EQ(FixedClock(schedule, host_rules(Dialect::shadertoy, true)).next().time_delta, 1.0 / 60.0);
}

TEST(FixedClock, TimeIsTheFrameNumberOverTheRateWhateverTheClockSays) {
  Schedule schedule;
  schedule.fps = 50.0;
  schedule.t0 = 2.0;
  FixedClock clock(schedule, host_rules(Dialect::shadertoy));
  for (int i = 0; i < 100; ++i) {
    const Frame frame = clock.next();
    EXPECT_EQ(frame.index, i);
    EXPECT_EQ(frame.time, 2.0 + i / 50.0);
    EXPECT_EQ(frame.time_delta, i == 0 ? 1.0 / 60.0 : 1.0 / 50.0);
  }
}

TEST(FixedClock, SecondRunWithTimeContinuesTheTimeOfTheFirst) {
  Schedule schedule;
  schedule.fps = 64.0;
  FixedClock whole(schedule, host_rules(Dialect::shadertoy));
  schedule.t0 = 0.5;
  FixedClock second_half(schedule, host_rules(Dialect::shadertoy));
  for (int i = 0; i < 32; ++i) whole.next();
  for (int i = 0; i < 32; ++i) {
    const Frame a = whole.next();
    const Frame b = second_half.next();
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.index, b.index + 32);  // the frame number and the buffers start anew
  }
}

TEST(FixedClock, DateRollsOverMidnightAndKeepsTheFraction) {
  Schedule schedule;
  schedule.fps = 2.0;
  schedule.date = Date::parse("2023-12-31T23:59:59.5");
  FixedClock clock(schedule, host_rules(Dialect::shadertoy));
  EXPECT_EQ(clock.next().date, glm::vec4(2023, 11, 31, 86399.5F));
  EXPECT_EQ(clock.next().date, glm::vec4(2024, 0, 1, 0));
  EXPECT_EQ(clock.next().date, glm::vec4(2024, 0, 1, 0.5F));
}

TEST(FixedClock, MouseStepsDrawADragFrameByFrame) {
  Schedule schedule;
  schedule.mouse = {{2, {100, 50}, true}, {4, {120, 60}, true}, {6, {130, 70}, false}};
  FixedClock clock(schedule, host_rules(Dialect::shadertoy));
  const std::vector<glm::vec4> expected = {{0, 0, 0, 0},         {0, 0, 0, 0},        {100, 50, 100, 50},
                                           {100, 50, 100, -50},  {120, 60, 100, -50}, {120, 60, 100, -50},
                                           {130, 70, -100, -50}, {130, 70, -100, -50}};
  for (const glm::vec4& value : expected) EXPECT_EQ(clock.next().mouse, value);
}

TEST(FixedClock, ClickWithoutDownShowsAReleasedButton) {
  Schedule schedule;
  schedule.mouse = {{0, {100, 50}, false}};
  FixedClock clock(schedule, host_rules(Dialect::shadertoy));
  EXPECT_EQ(clock.next().mouse, glm::vec4(100, 50, -100, -50));
}

TEST(FixedClock, KeysAreHeldFromTheirFrameOn) {
  Schedule schedule;
  schedule.keys = {{1, 65}};
  FixedClock clock(schedule, host_rules(Dialect::shadertoy));
  EXPECT_EQ(clock.next().keyboard[65], 0);
  const Frame pressed = clock.next();
  EXPECT_EQ(pressed.keyboard[65], 255);
  EXPECT_EQ(pressed.keyboard[256 + 65], 255);
  const Frame held = clock.next();
  EXPECT_EQ(held.keyboard[65], 255);
  EXPECT_EQ(held.keyboard[256 + 65], 0);
}

TEST(FixedClock, KeysAreLetGoAndPressedAgain) {
  Schedule schedule;
  schedule.keys = {{1, 65, 3}, {3, 65, 4}, {5, 65, 5}};
  using Rows = std::vector<std::vector<int>>;
  for (const Dialect dialect : {Dialect::shadertoy, Dialect::vscode}) {
    FixedClock clock(schedule, host_rules(dialect));
    Rows seen;
    for (int i = 0; i < 7; ++i) {
      const Frame frame = clock.next();
      seen.push_back({});
      for (std::size_t row = 0; row < 4; ++row) seen.back().push_back(frame.keyboard[256 * row + 65] / 255);
    }
    // Held, pressed, toggled, released. A tap between two frames shows as pressed in the extension only.
    const int tapped = dialect == Dialect::vscode ? 1 : 0;
    EXPECT_EQ(seen, (Rows{{0, 0, 0, 0},
                          {1, 1, 1, 0},
                          {1, 0, 1, 0},
                          {1, 1, 0, 1},
                          {0, 0, 0, 1},
                          {0, tapped, 1, 1},
                          {0, 0, 1, 0}}));
  }
}

TEST(Date, RefusesWhatIsNoDate) {
  for (const char* text : {"", "yesterday", "2023-02-29", "2023-13-01", "2023-01-01T24:00", "2023-01-01T10",
                           "2023-01-01x", "2023-01-01T10:00:61"}) {
    EXPECT_THROW(Date::parse(text), Error) << text;
  }
  EXPECT_EQ(Date::parse("2024-02-29T01:02:03.25").seconds, 3723.25);
}

TEST(Date, TextReadsBack) {
  for (const char* text : {"2024-01-01T00:00:00", "2025-12-31T23:59:59.5", "0999-02-03T04:05:06.125"}) {
    EXPECT_EQ(Date::parse(text).text(), text);
    EXPECT_EQ(Date::parse(Date::parse(text).text()), Date::parse(text));
  }
}

}  // namespace
}  // namespace shadertwin

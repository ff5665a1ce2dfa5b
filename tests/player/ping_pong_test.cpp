#include "host/player/ping_pong.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

// Pass 0 reads pass 1, which reads itself; pass 2 reads pass 1.
Project early_and_late_reader(bool quirks) {
  Project project;
  project.dialect = Dialect::vscode;
  project.vscode_quirks = quirks;
  project.passes.resize(3);
  for (Pass& pass : project.passes) {
    pass.inputs[0].kind = InputKind::pass;
    pass.inputs[0].pass = 1;
  }
  return project;
}

Frame wide_frame(int index, int width) {
  Frame frame;
  frame.index = index;
  frame.width = width;
  frame.height = 9;
  frame.time = 7.0;
  frame.time_delta = 0.5;
  return frame;
}

// The targets of pass 1 that passes 0, 1 and 2 read, and the one that it draws into, while a frame is drawn.
std::vector<std::size_t> play(PingPong& ping_pong) {
  std::vector<std::size_t> seen;
  for (std::size_t pass = 0; pass < 3; ++pass) {
    seen.push_back(ping_pong.read_by(pass, 1));
    if (pass == 1) seen.push_back(ping_pong.back(1));
    ping_pong.drawn(pass);
  }
  return seen;
}

TEST(PingPong, EarlierReadersSeeTheLastFrameAndLaterOnesThisOne) {
  PingPong ping_pong(early_and_late_reader(false));
  EXPECT_EQ(ping_pong.targets(0), 1U);
  EXPECT_EQ(ping_pong.targets(1), 2U);
  EXPECT_FALSE(ping_pong.begin(wide_frame(0, 16)).has_value());
  const auto first = play(ping_pong);
  const std::size_t drawn = first[2];
  EXPECT_EQ(first, (std::vector<std::size_t>{1 - drawn, 1 - drawn, drawn, drawn}));
  EXPECT_FALSE(ping_pong.begin(wide_frame(1, 16)).has_value());
  EXPECT_EQ(play(ping_pong), (std::vector<std::size_t>{drawn, drawn, 1 - drawn, 1 - drawn}));
}

TEST(PingPong, WithTheExtensionsQuirksEarlierReadersSeeTheFrameBeforeTheLast) {
  PingPong ping_pong(early_and_late_reader(true));
  const auto warm_up = ping_pong.begin(wide_frame(0, 16));
  ASSERT_TRUE(warm_up.has_value());
  EXPECT_EQ(warm_up->index, 0);
  EXPECT_EQ(warm_up->time, 0.0);
  EXPECT_EQ(warm_up->time_delta, 0.0);
  const std::size_t target = ping_pong.back(1);
  EXPECT_EQ(play(ping_pong), (std::vector<std::size_t>{target, 1 - target, target, target}));
  ping_pong.end_warm_up();
  EXPECT_EQ(play(ping_pong), (std::vector<std::size_t>{target, 1 - target, target, target}))
      << "frame 0 draws where the warm-up did, and shows it to earlier passes";
  ping_pong.begin(wide_frame(1, 16));
  EXPECT_EQ(play(ping_pong), (std::vector<std::size_t>{1 - target, target, 1 - target, 1 - target}));
}

TEST(PingPong, OnlyAStartIsWarmedUpAndMeasuredWithTheExtensionsQuirks) {
  PingPong ping_pong(early_and_late_reader(true));
  const auto begin = [&](int index, int width) {
    const bool warm_up = ping_pong.begin(wide_frame(index, width)).has_value();
    ping_pong.end_warm_up();
    return warm_up;
  };
  EXPECT_TRUE(begin(0, 16));
  EXPECT_FALSE(begin(1, 16));
  EXPECT_FALSE(begin(0, 32)) << "a resize";
  EXPECT_EQ(ping_pong.reported_size(), glm::ivec2(16, 9));
  EXPECT_FALSE(begin(1, 32));
  EXPECT_TRUE(begin(0, 32)) << "back to zero";
  EXPECT_EQ(ping_pong.reported_size(), glm::ivec2(32, 9));

  PingPong without(early_and_late_reader(false));
  without.begin(wide_frame(0, 16));
  without.begin(wide_frame(0, 32));
  EXPECT_EQ(without.reported_size(), glm::ivec2(32, 9));
}

}  // namespace
}  // namespace shadertwin

#include "host/player/rounds.h"

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

Frame frame_of(int index, int width) {
  Frame frame;
  frame.index = index;
  frame.width = width;
  frame.height = 9;
  frame.time = 7.0;
  frame.time_delta = 0.5;
  return frame;
}

// The pictures of pass 1 that passes 0, 1 and 2 read, and the one that it draws into, while a frame is drawn.
std::vector<std::size_t> play(Rounds& rounds) {
  std::vector<std::size_t> seen;
  for (std::size_t pass = 0; pass < 3; ++pass) {
    seen.push_back(rounds.read_by(pass, 1));
    if (pass == 1) seen.push_back(rounds.target(1));
    rounds.drawn(pass);
  }
  return seen;
}

TEST(Rounds, EarlierReadersSeeTheLastFrameAndLaterOnesThisOne) {
  Rounds rounds(early_and_late_reader(false));
  EXPECT_EQ(rounds.pictures(0), 1U);
  EXPECT_EQ(rounds.pictures(1), 2U);
  EXPECT_FALSE(rounds.begin(frame_of(0, 16)).has_value());
  const auto first = play(rounds);
  const std::size_t drawn = first[2];
  EXPECT_EQ(first, (std::vector<std::size_t>{1 - drawn, 1 - drawn, drawn, drawn}));
  EXPECT_FALSE(rounds.begin(frame_of(1, 16)).has_value());
  EXPECT_EQ(play(rounds), (std::vector<std::size_t>{drawn, drawn, 1 - drawn, 1 - drawn}));
}

TEST(Rounds, WithTheExtensionsQuirksEarlierReadersSeeTheFrameBeforeTheLast) {
  Rounds rounds(early_and_late_reader(true));
  const auto rehearsal = rounds.begin(frame_of(0, 16));
  ASSERT_TRUE(rehearsal.has_value());
  EXPECT_EQ(rehearsal->index, 0);
  EXPECT_EQ(rehearsal->time, 0.0);
  EXPECT_EQ(rehearsal->time_delta, 0.0);
  const std::size_t target = rounds.target(1);
  EXPECT_EQ(play(rounds), (std::vector<std::size_t>{target, 1 - target, target, target}));
  rounds.end_rehearsal();
  EXPECT_EQ(play(rounds), (std::vector<std::size_t>{target, 1 - target, target, target}))
      << "frame 0 draws where the rehearsal did, and shows its picture to earlier passes";
  rounds.begin(frame_of(1, 16));
  EXPECT_EQ(play(rounds), (std::vector<std::size_t>{1 - target, target, 1 - target, 1 - target}));
}

TEST(Rounds, OnlyAStartIsRehearsedAndMeasuredWithTheExtensionsQuirks) {
  Rounds rounds(early_and_late_reader(true));
  const auto begin = [&](int index, int width) {
    const bool rehearsal = rounds.begin(frame_of(index, width)).has_value();
    rounds.end_rehearsal();
    return rehearsal;
  };
  EXPECT_TRUE(begin(0, 16));
  EXPECT_FALSE(begin(1, 16));
  EXPECT_FALSE(begin(0, 32)) << "a resize";
  EXPECT_EQ(rounds.reported_size(), glm::ivec2(16, 9));
  EXPECT_FALSE(begin(1, 32));
  EXPECT_TRUE(begin(0, 32)) << "back to zero";
  EXPECT_EQ(rounds.reported_size(), glm::ivec2(32, 9));

  Rounds without(early_and_late_reader(false));
  without.begin(frame_of(0, 16));
  without.begin(frame_of(0, 32));
  EXPECT_EQ(without.reported_size(), glm::ivec2(32, 9));
}

}  // namespace
}  // namespace shadertwin

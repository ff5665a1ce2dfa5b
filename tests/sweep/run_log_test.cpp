#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

#include "host/base/error.h"
#include "host/sweep/measurement.h"
#include "tests/scratch_folder.h"

namespace shadertwin::sweep {
namespace {

Measurement measurement(const std::string& key, int run, int frames, double error) {
  Measurement m;
  m.key = key;
  m.run = run;
  m.frames = frames;
  m.milliseconds = 1.0 / 3.0;
  m.gpu = true;
  m.relative_mse = error;
  m.nan = 5;
  return m;
}

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(RunLog, GivesBackWhatAnEarlierOneHeld) {
  const ScratchFolder folder;
  RunLog(folder / "a.runs.csv")
      .add({measurement("k", 1, 2, 0.25), measurement("k", 1, 1, 0.5)}, "A=\"x\", B=2");
  const RunLog log(folder / "a.runs.csv");
  EXPECT_TRUE(log.has("k", 1, 1));
  EXPECT_FALSE(log.has("k", 1, 3));
  EXPECT_FALSE(log.has("k", 0, 1));
  EXPECT_FALSE(log.has("other", 1, 1));
  const auto all = log.of("k");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].frames, 1);
  EXPECT_EQ(all[0].relative_mse, 0.5);
  EXPECT_NEAR(all[0].milliseconds, 1.0 / 3.0, 1e-7);
  EXPECT_TRUE(all[0].gpu);
  EXPECT_TRUE(std::isnan(all[0].flip));
  EXPECT_EQ(all[1].nan, 5U);
}

TEST(RunLog, DropsALineThatBrokeOff) {
  const ScratchFolder folder;
  { RunLog(folder / "a.runs.csv").add({measurement("k", 0, 1, 0.5), measurement("k", 1, 1, 0.5)}, ""); }
  const std::string whole = contents(folder / "a.runs.csv");
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t length = last; length < whole.size(); ++length) {
    std::ofstream(folder / "a.runs.csv") << whole.substr(0, length);
    RunLog log(folder / "a.runs.csv");
    EXPECT_TRUE(log.has("k", 0, 1)) << length;
    EXPECT_FALSE(log.has("k", 1, 1)) << length;
    EXPECT_EQ(contents(folder / "a.runs.csv"), whole.substr(0, last)) << length;
  }
}

TEST(RunLog, TakesAHeaderThatBrokeOffForAnEmptyLog) {
  const ScratchFolder folder;
  { const RunLog log(folder / "a.runs.csv"); }
  const std::string header = contents(folder / "a.runs.csv");
  for (std::size_t length = 0; length <= header.size(); ++length) {
    std::ofstream(folder / "a.runs.csv") << header.substr(0, length);
    { const RunLog log(folder / "a.runs.csv"); }
    EXPECT_EQ(contents(folder / "a.runs.csv"), header) << length;
  }
}

TEST(RunLog, KeepsWhatItHeldWhenTheDiskIsFull) {
  const ScratchFolder folder;
  { RunLog(folder / "a.runs.csv").add({measurement("k", 0, 1, 0.5)}, ""); }
  const std::string whole = contents(folder / "a.runs.csv");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit full{.rlim_cur = whole.size() / 2, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  EXPECT_THROW(RunLog(folder / "a.runs.csv").add({measurement("k", 1, 1, 0.5)}, ""), Error);
  EXPECT_THROW(RunLog(folder / "b.runs.csv").add({measurement("k", 1, 1, 0.5)}, ""), Error);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(contents(folder / "a.runs.csv"), whole);
}

TEST(RunLog, ReplacesARunThatBrokeOff) {
  const ScratchFolder folder;
  RunLog(folder / "a.runs.csv").add({measurement("k", 0, 1, 0.5)}, "");
  RunLog(folder / "a.runs.csv").add({measurement("k", 0, 1, 0.25), measurement("k", 0, 2, 0.125)}, "");
  const auto all = RunLog(folder / "a.runs.csv").of("k");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].relative_mse, 0.25);
}

TEST(RunLog, LeavesOtherFilesAlone) {
  const ScratchFolder folder;
  std::ofstream(folder / "a.csv") << "mine\n1,2\n";
  EXPECT_THROW(RunLog(folder / "a.csv"), Error);
  EXPECT_EQ(contents(folder / "a.csv"), "mine\n1,2\n");
}

}  // namespace
}  // namespace shadertwin::sweep

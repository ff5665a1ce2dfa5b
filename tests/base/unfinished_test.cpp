#include "host/base/unfinished.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include "host/base/output_file.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

// Runs `work` in a process of its own until it has written `sign`, then interrupts it. True if the signal
// ended it.
bool interrupted(int signal, const fs::path& sign, const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    remove_unfinished_when_interrupted();
    work();
    write_text(sign, "");
    for (;;) pause();
  }
  while (!fs::exists(sign)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  fs::remove(sign);
  return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

TEST(Unfinished, InterruptLeavesTheFolderOfAnOutputFileAsItWas) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const ScratchFolder folder;
    write_text(folder / "a.png", "old");
    EXPECT_TRUE(interrupted(signal, folder / "sign", [&] {
      auto* output = new OutputFile(folder / "a.png");
      write_text(output->path(), "half");
    }));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "signal " << signal;
    EXPECT_EQ(fs::file_size(folder / "a.png"), 3U);
  }
}

TEST(Unfinished, InterruptKeepsWhatWasCommitted) {
  const ScratchFolder folder;
  EXPECT_TRUE(interrupted(SIGTERM, folder / "sign", [&] {
    OutputFile output(folder / "a.png");
    write_text(output.path(), "whole");
    output.commit();
  }));
  EXPECT_TRUE(fs::exists(folder / "a.png"));
}

TEST(Unfinished, InterruptRemovesAFolderAfterItsFilesAndOnlyThose) {
  const ScratchFolder folder;
  EXPECT_TRUE(interrupted(SIGINT, folder / "sign", [&] {
    auto* whole = new Unfinished(folder / "whole");
    auto* file = new Unfinished(folder / "whole/file");
    auto* kept = new Unfinished(folder / "kept");
    fs::create_directory(folder / "whole");
    fs::create_directory(folder / "kept");
    write_text(folder / "whole/file", "");
    write_text(folder / "kept/file of another", "");
    delete new Unfinished(folder / "kept/file of another");
    static_cast<void>(whole), static_cast<void>(file), static_cast<void>(kept);
  }));
  EXPECT_FALSE(fs::exists(folder / "whole"));
  EXPECT_TRUE(fs::exists(folder / "kept/file of another"));
}

TEST(Unfinished, IgnoredSignalStaysIgnored) {
  const ScratchFolder folder;
  EXPECT_TRUE(interrupted(SIGTERM, folder / "sign", [&] {
    std::signal(SIGHUP, SIG_IGN);
    remove_unfinished_when_interrupted();
    auto* output = new Unfinished(folder / "a");
    static_cast<void>(output);
    write_text(folder / "a", "");
    raise(SIGHUP);
    if (!fs::exists(folder / "a")) _exit(0);
  }));
  EXPECT_FALSE(fs::exists(folder / "a"));
}

// There is room for 256 names. The 257th and later ones stay behind, and room that is given back is used
// again.
TEST(Unfinished, MoreThanFitAreLeftAlone) {
  constexpr int room = 256;
  constexpr int count = 300;
  const ScratchFolder folder;
  EXPECT_TRUE(interrupted(SIGINT, folder / "sign", [&] {
    auto* many = new std::vector<Unfinished>;
    for (int i = 0; i < count; ++i) {
      many->emplace_back(folder / std::to_string(i));
      write_text(folder / std::to_string(i), "");
    }
    many->erase(many->begin() + 7);
    many->emplace_back(folder / "late");
    write_text(folder / "late", "");
  }));
  for (int i = 0; i < count; ++i) EXPECT_EQ(fs::exists(folder / std::to_string(i)), i == 7 || i >= room) << i;
  EXPECT_FALSE(fs::exists(folder / "late"));
}

}  // namespace
}  // namespace shadertwin

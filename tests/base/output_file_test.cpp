#include "host/base/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

#include "host/base/error.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void expect_file_error(const fs::path& target) {
  try {
    const OutputFile output(target);
    FAIL() << target << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::file);
    EXPECT_EQ(std::string(error.what()).rfind(target.string() + ": ", 0), 0u) << error.what();
  }
}

TEST(OutputFile, AppearsOnlyWithCommit) {
  const ScratchFolder folder;
  OutputFile output(folder / "a.png");
  write_text(output.path(), "whole");
  EXPECT_FALSE(fs::exists(folder / "a.png"));
  output.commit();
  EXPECT_EQ(read_text(folder / "a.png"), "whole");
  EXPECT_FALSE(fs::exists(output.path()));
}

TEST(OutputFile, WithoutCommitTheFolderStaysAsItWas) {
  const ScratchFolder folder;
  write_text(folder / "a.png", "old");
  {
    const OutputFile output(folder / "a.png");
    write_text(output.path(), "half");
  }
  EXPECT_EQ(read_text(folder / "a.png"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(OutputFile, ReplacesAnOlderFile) {
  const ScratchFolder folder;
  write_text(folder / "a.png", "old");
  OutputFile output(folder / "a.png");
  write_text(output.path(), "new");
  output.commit();
  EXPECT_EQ(read_text(folder / "a.png"), "new");
}

TEST(OutputFile, TheTemporaryNameKeepsFolderAndExtension) {
  const ScratchFolder folder;
  const OutputFile output(folder / "a.tar.exr");
  EXPECT_EQ(output.path().parent_path(), folder.path());
  EXPECT_EQ(output.path().extension(), ".exr");
}

TEST(OutputFile, TwoForOneTargetDoNotMeet) {
  const ScratchFolder folder;
  const OutputFile one(folder / "a.png");
  const OutputFile other(folder / "a.png");
  EXPECT_NE(one.path(), other.path());
}

TEST(OutputFile, TakesTheLongestNameThatTheFileSystemTakes) {
  const ScratchFolder folder;
  const fs::path target = folder / (std::string(251, 'n') + ".png");
  OutputFile output(target);
  write_text(output.path(), "whole");
  output.commit();
  EXPECT_EQ(read_text(target), "whole");
}

TEST(OutputFile, RefusesAMissingFolderAFolderAndAFileAsFolder) {
  const ScratchFolder folder;
  expect_file_error(folder / "missing/a.png");
  fs::create_directory(folder / "a.png");
  expect_file_error(folder / "a.png");
  write_text(folder / "file", "");
  expect_file_error(folder / "file/a.png");
}

TEST(OutputFile, LeavesDevicesAndPipesInTheirPlace) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  expect_file_error(folder / "pipe.png");
  expect_file_error("/dev/null");
  fs::create_symlink("/dev/null", folder / "null.png");
  expect_file_error(folder / "null.png");
}

TEST(OutputFile, RefusesAFolderThatCannotBeWritten) {
  if (geteuid() == 0) {
    expect_file_error("/proc/a.png");  // not even root can
    return;
  }
  const ScratchFolder folder;
  fs::create_directory(folder / "locked");
  fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expect_file_error(folder / "locked/a.png");
}

TEST(OutputFile, CommitReportsAFileThatWasNeverWritten) {
  const ScratchFolder folder;
  OutputFile output(folder / "a.png");
  EXPECT_THROW(output.commit(), Error);
}

}  // namespace
}  // namespace shadertwin

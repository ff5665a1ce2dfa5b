#include "host/view/file_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/scratch_folder.h"

namespace shadertwin::view {
namespace {

TEST(FileWatch, SeesAWrittenAReplacedAndARemovedFile) {
  const ScratchFolder folder;
  const auto file = folder.write("a.glsl", "1");
  folder.write("b.glsl", "1");
  FileWatch watch;
  watch.set_files({file});
  EXPECT_FALSE(watch.changed());
  folder.write("a.glsl", "2");
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
  std::filesystem::rename(folder / "b.glsl", file);
  EXPECT_TRUE(watch.changed());
  std::filesystem::remove(file);
  EXPECT_TRUE(watch.changed());
  folder.write("a.glsl", "3");
  EXPECT_TRUE(watch.changed());
}

TEST(FileWatch, ReportsWhatWasSavedAfterItWasReadAndBeforeItWasWatched) {
  const ScratchFolder folder;
  const auto old = folder.write("old.glsl", "1");
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // longer than a tick of the file clock
  const FileWatch::Stamp read = FileWatch::now();
  FileWatch watch;
  watch.set_files({old}, read);
  EXPECT_FALSE(watch.missed());
  EXPECT_FALSE(watch.changed());
  const auto saved = folder.write("saved.glsl", "1");
  EXPECT_TRUE(watch.changed(true));  // the folder was watched already
  watch.set_files({old, saved}, read);
  EXPECT_TRUE(watch.missed());
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.missed());
  EXPECT_FALSE(watch.changed());
  watch.set_files({old, saved}, read);
  EXPECT_FALSE(watch.changed()) << "watched all the time: its changes are told as they happen";
  FileWatch another;
  another.set_files({folder.path()}, read);
  EXPECT_TRUE(another.changed());
}

TEST(FileWatch, OverlooksItsNeighboursUnlessAsked) {
  const ScratchFolder folder;
  FileWatch watch;
  watch.set_files({folder.write("a.glsl", "1")});
  folder.write("other.txt", "1");
  EXPECT_FALSE(watch.changed());
  folder.write("other.txt", "2");
  EXPECT_TRUE(watch.changed(true));
}

TEST(FileWatch, FollowsALinkToItsTarget) {
  const ScratchFolder folder;
  const auto target = folder.write("there/real.glsl", "1");
  folder.write("here/.keep", "");
  std::filesystem::create_symlink(target, folder / "here/link.glsl");
  FileWatch watch;
  watch.set_files({folder / "here/link.glsl"});
  folder.write("there/real.glsl", "2");
  EXPECT_TRUE(watch.changed());
}

TEST(FileWatch, AFolderStandsForWhatIsInIt) {
  const ScratchFolder folder;
  FileWatch watch;
  watch.set_files({folder.path()});
  folder.write("buffer_a.glsl", "1");
  EXPECT_TRUE(watch.changed());
}

TEST(FileWatch, ForgetsWhatIsNoLongerNamed) {
  const ScratchFolder folder;
  const auto a = folder.write("one/a.glsl", "1");
  const auto b = folder.write("two/b.glsl", "1");
  FileWatch watch;
  watch.set_files({a});
  watch.set_files({b});
  folder.write("one/a.glsl", "2");
  EXPECT_FALSE(watch.changed());
  folder.write("two/b.glsl", "2");
  EXPECT_TRUE(watch.changed());
}

}  // namespace
}  // namespace shadertwin::view

// Tests keep their compiled twins in the build, not in the user's cache.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace {

class CacheFolder : public testing::Environment {
 public:
  void SetUp() override {
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cache";
    setenv("XDG_CACHE_HOME", folder.c_str(), 1);
  }
};

const testing::Environment* const cache_folder = testing::AddGlobalTestEnvironment(new CacheFolder);

}  // namespace

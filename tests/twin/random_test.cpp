// One of the random shaders; tools/nightly runs others.
#include <gtest/gtest.h>

#include <fstream>

#include "host/text/load.h"
#include "tests/emit/random_shader.h"
#include "tests/scratch_folder.h"
#include "tests/twin/agreement.h"

namespace shadertwin {
namespace {

class RandomShaders : public testing::TestWithParam<unsigned> {};

TEST_P(RandomShaders, RunAlikeOnLlvmpipeAndEveryTwin) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "random.glsl";
  std::ofstream(file) << random_shader(GetParam());
  EXPECT_EQ(disagreements(load_project(file), {}), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(, RandomShaders, testing::Values(5));

}  // namespace
}  // namespace shadertwin

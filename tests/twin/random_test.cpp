// A few of the random shaders; `shadertwin-agreement --count N` runs more.
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

INSTANTIATE_TEST_SUITE_P(, RandomShaders, testing::Values(5, 6));

}  // namespace
}  // namespace shadertwin

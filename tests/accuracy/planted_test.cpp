// Shaders that lose digits in one place each, and the same shaders repaired. `// here: KIND` marks the line.
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

namespace fs = std::filesystem;

struct Planted {
  std::string kind;
  int line = 0;
  std::string options;
};

Planted read_marks(const fs::path& file) {
  Planted planted;
  std::ifstream stream(file);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string here = "// here: ";
    const std::string options = "// options:";
    if (const auto at = line.find(here); at != std::string::npos) {
      planted.kind = line.substr(at + here.size());
      planted.line = number;
    }
    if (line.starts_with(options)) planted.options = line.substr(options.size());
  }
  return planted;
}

std::vector<std::string> planted_shaders() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(SHADERTWIN_SOURCE_DIR "/tests/accuracy/shaders"))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class PlantedLoss : public testing::TestWithParam<std::string> {
 protected:
  Outcome judge(const std::string& options) const {
    return run(folder, "accuracy '" + file.string() + "' --size 32x18 " + planted.options + options);
  }
  ScratchFolder folder;
  fs::path file = SHADERTWIN_SOURCE_DIR "/tests/accuracy/shaders/" + GetParam() + ".glsl";
  Planted planted = read_marks(file);
};

TEST_P(PlantedLoss, IsTheFirstFindingAtItsLine) {
  ASSERT_NE(planted.line, 0);
  const Outcome outcome = judge("");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string wanted = file.string() + ':' + std::to_string(planted.line) + ": " + planted.kind + ": ";
  EXPECT_EQ(outcome.out.substr(0, wanted.size()), wanted) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find(planted.kind == "branch" ? "moves the picture" : "reaches the picture"),
            std::string::npos);
}

TEST_P(PlantedLoss, IsGoneFromTheRepairedTwin) {
  const Outcome outcome = judge(" -D REPAIRED");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

// The path tracer's sphere, a thousand radii away.
class FarSphere : public testing::Test {
 protected:
  Outcome judge(const std::string& root) const {
    folder.write("sphere.glsl", "#include \"" + common.string() + R"("
void mainImage(out vec4 color, in vec2 position) {
  vec2 uv = (position - 0.5 * iResolution.xy) / iResolution.y;
  vec3 d = normalize(vec3(0.0025 * uv, -1.0));
  vec3 origin = vec3(0.0, 0.0, 1000.0);
  vec2 roots = vec2(0.0);
  color = vec4(0.0);
  if (sphereRoots(origin, d, 1.0, roots)) color = vec4(0.5 + 0.5 * (origin + roots.x * d), 1.0);
}
)");
    return run(folder, "accuracy sphere.glsl --size 32x18 -D SPHERE_ROOT=" + root);
  }
  ScratchFolder folder;
  fs::path common = SHADERTWIN_SOURCE_DIR "/shadertoy/common.glsl";
};

TEST_F(FarSphere, LosesItsDigitsInTheTextbooksRoot) {
  std::ifstream stream(common);
  int number = 1;
  for (std::string line; std::getline(stream, line) && line.find("= b * b - c;") == std::string::npos;)
    ++number;
  const Outcome outcome = judge("1");
  const std::string wanted = common.string() + ':' + std::to_string(number) + ": cancellation: ";
  EXPECT_EQ(outcome.out.substr(0, wanted.size()), wanted) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("bits lost in b * b - c (at worst, pixel "), std::string::npos) << outcome.out;
}

TEST_F(FarSphere, IsSilentWithTheRobustRoot) {
  const Outcome outcome = judge("0");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(, PlantedLoss, testing::ValuesIn(planted_shaders()),
                         [](const auto& planted) { return planted.param; });

}  // namespace
}  // namespace shadertwin

// Whole paths have the same bits everywhere.
#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::path_test {
namespace {

class Paths : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Paths);

using Defines = std::vector<std::pair<std::string, std::string>>;

// Of 64 views, 8 times each.
Table views(std::uint64_t seed, const std::function<std::pair<glm::dvec3, glm::dvec3>(Random&)>& view) {
  Random random(seed);
  Table inputs(512, 2);
  for (std::size_t i = 0; i < inputs.cases(); i += 8) {
    const auto [eye, towards] = view(random);
    for (std::size_t b = 0; b < 8; ++b) {
      inputs.at(i + b, 0) = texel(eye, static_cast<double>(b));
      inputs.at(i + b, 1) = texel(glm::normalize(towards));
    }
  }
  return inputs;
}

TEST_P(Paths, OfAFurnaceAndOfTheCornellBoxAreTheSameEverywhere) {
  const auto mean = [this](const Table& inputs, const Defines& defines) {
    const Table got = run({.file = "paths.glsl", .inputs = 2, .outputs = 3, .defines = defines}, inputs);
    double sum = 0.0;
    for (std::size_t i = 0; i < got.cases(); ++i) {
      sum += got.at(i, 0).y / static_cast<double>(got.cases());
      EXPECT_EQ(got.at(i, 2).z, 0.0F) << "values that are no numbers";
      EXPECT_GE(got.at(i, 2).y, 0.0F);
    }
    return sum;
  };
  const Table inside = views(137, [](Random& random) {
    return std::pair{0.5 * random_direction(random), random_direction(random)};
  });
  EXPECT_NEAR(mean(inside, {{"ROOM", "1"}, {"SAMPLES", "8"}, {"ALBEDO", "0.5"}, {"MAX_BOUNCES", "60"}}), 2.0,
              0.05);
  const Table outside = views(138, [](Random& random) {
    const glm::dvec3 eye(0, 3, 11);
    return std::pair{eye, glm::dvec3(random.uniform(-3.5, 3.5), random.uniform(0.3, 5.5), -2) - eye};
  });
  EXPECT_GT(mean(outside, {{"ROOM", "9"}, {"SAMPLES", "4"}, {"MAX_BOUNCES", "8"}}), 0.1);
}

}  // namespace
}  // namespace shadertwin::path_test

// Pictures after a day and a year, and means of a million frames.
#include <cmath>
#include <cstdint>

#include "tests/shadertoy/bar.h"

namespace shadertwin::time_test {
namespace {

class Time : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Time);

constexpr double u = unit_roundoff;
constexpr int a_year = 365 * 24 * 3600;  // seconds

struct Apart {
  double mean = 0.0, deviation = 0.0;  // of the differences of pixels
  double numbers = 0.0;
};

Apart apart(const Image& a, const Image& b) {
  double sum = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    // Fireflies would decide alone.
    const double difference =
        std::min(static_cast<double>(a.rgba[i]), 2.0) - std::min(static_cast<double>(b.rgba[i]), 2.0);
    sum += difference;
    squares += difference * difference;
    count += 1.0;
  }
  return {sum / count, std::sqrt(squares / count), count};
}

// iFrame of a year at 60 frames a second is below 2^31, its samples are beyond it, and iTime has a resolution
// of two seconds. The noise is as it was, and another one.
TEST_P(Time, ADayAndAYearLaterTheNoiseIsTheSame) {
  for (const char* numbers : {"0", "1", "2"}) {
    // A twin takes seconds to compile.
    if (GetParam() != backends().front().name && numbers[0] != '1') continue;
    const auto after = [&](int seconds) {
      Take take{.file = "../../shadertoy/image.glsl",
                .width = 48,
                .height = 27,
                .frames = 4,
                .defines = {{"SCENE", "4"}, {"SAMPLES_PER_FRAME", "2"}, {"RANDOM_NUMBERS", numbers}},
                .pass = "P3D_RT",
                .first_frame = 60 * seconds,
                .time = static_cast<double>(seconds)};
      return play(take);
    };
    const Image start = after(0);
    const Apart minute = apart(start, after(60));
    for (const int seconds : {a_year / 365, a_year}) {
      const Image late = after(seconds);
      Bar samples("samples a day or a year later that are no numbers");
      for (std::size_t i = 3; i < late.rgba.size(); i += 4)
        samples.near(late.rgba[i], 8.0, 0.0, {{"seconds", seconds}, {"number", i}});
      const Apart got = apart(start, late);
      EXPECT_NEAR(got.deviation / minute.deviation, 1.0, 0.1) << seconds << " s, RANDOM_NUMBERS " << numbers;
      EXPECT_NEAR(got.mean, 0.0, 5.0 * got.deviation / std::sqrt(got.numbers / 3.0))
          << seconds << " s, RANDOM_NUMBERS " << numbers;
    }
  }
}

// A multiple of the golden ratio's 2^32, as the shader has it.
double golden(std::uint32_t i) {
  return (i * 2654435769U >> 8) * 0x1p-24;
}

TEST_P(Time, AMillionFramesHaveTheirMean) {
  struct Case {
    float least, range;
  };
  const std::vector<Case> cases = {{0, 1},   {0, 1e-3F},   {0, 20},  {0.5F, 1e-3F},
                                   {100, 1}, {1e4F, 1e4F}, {0.1F, 0}};
  // llvmpipe ends loops after 65,534 turns.
  constexpr std::uint32_t at_once = 50000;
  constexpr std::uint32_t frames = 1000000;
  Table means(cases.size(), 2);
  std::vector<double> sums(cases.size());
  for (std::uint32_t first = 0; first < frames; first += at_once) {
    for (std::size_t i = 0; i < cases.size(); ++i)
      means.at(i, 1) = glm::vec4(first, at_once, cases[i].least, cases[i].range);
    const Table got = run({.file = "display.glsl", .function = 3, .inputs = 2}, means);
    for (std::size_t i = 0; i < cases.size(); ++i) means.at(i, 0) = got.at(i, 0);
  }
  for (std::uint32_t k = 0; k < frames; ++k)
    for (std::size_t i = 0; i < cases.size(); ++i)
      sums[i] += static_cast<double>(cases[i].least) + static_cast<double>(cases[i].range) * golden(k);
  Bar bar("mean of a million frames, relative error");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double expected = sums[i] / frames;
    bar.near(means.at(i, 0).x / expected, 1.0, 4e-6, {{"least", cases[i].least}, {"range", cases[i].range}});
    EXPECT_EQ(means.at(i, 0).w, static_cast<float>(frames));
  }
}

// 2^24 + 1 is no float: from there on the mean stays where it is, which is where it belongs.
TEST_P(Time, FramesBeyondTheLastCountChangeNothing) {
  Table inputs(4, 2);
  for (std::size_t i = 0; i < inputs.cases(); ++i) {
    inputs.at(i, 0) = glm::vec4(0.25, 0.5, 1e-3, 0x1p24);
    inputs.at(i, 1) = glm::vec4(i % 2 ? 1.0 : 0.0, i < 2 ? 1.0 : 0.0, 2e-3, 0.0);
  }
  const Table got = run({.file = "display.glsl", .function = 2, .inputs = 2}, inputs);
  Bar bar("mean of 2^24 frames and one more");
  for (std::size_t i = 0; i < inputs.cases(); ++i)
    for (int j = 0; j < 4; ++j) {
      const double mean = inputs.at(i, 0)[j];
      bar.near(got.at(i, 0)[j], mean, j == 3 ? 1.0 : 0x1p-24 + u * mean, {{"case", i}, {"component", j}});
    }
}

}  // namespace
}  // namespace shadertwin::time_test

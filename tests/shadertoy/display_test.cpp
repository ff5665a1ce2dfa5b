// The mean of many frames, tone curves, and sRGB both ways.
#include <cmath>
#include <limits>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/random.h"
#include "tests/shadertoy/shapes.h"

namespace shadertwin::display_test {
namespace {

class Accumulate : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Accumulate);
class Tone : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Tone);
class Srgb : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Srgb);

const Probe curves{.file = "display.glsl", .function = 0, .inputs = 2, .outputs = 1};
const Probe means{.file = "display.glsl", .function = 1, .inputs = 2, .outputs = 1};
const Probe samples{.file = "display.glsl", .function = 2, .inputs = 2, .outputs = 1};

// IEC 61966-2-1.
double decode(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
double encode(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

TEST_P(Srgb, EveryCodeIsDecodedAndComesBack) {
  Table inputs(256, 2);
  for (std::size_t i = 0; i < 256; ++i) inputs.at(i, 0).x = static_cast<float>(i) / 255.0F;
  const Table got = run(curves, inputs);
  Bar decoded("srgbDecode, the 256 codes");
  Bar back("sRGB there and back, the 256 codes");
  for (std::size_t i = 0; i < 256; ++i) {
    decoded.near(static_cast<double>(got.at(i, 0).x), decode(static_cast<double>(i) / 255.0), 1e-6,
                 {{"code", i}});
    back.near(std::round(255.0 * static_cast<double>(got.at(i, 0).z)), static_cast<double>(i), 0.0,
              {{"code", i}});
  }
}

TEST_P(Srgb, EncodesTheUnitIntervalAndClampsTheRest) {
  constexpr std::size_t count = std::size_t{1} << 20;
  Random random(81);
  Table inputs(count, 2);
  for (std::size_t i = 0; i < count; ++i)
    inputs.at(i, 0).y = static_cast<float>(i % 2 ? random.uniform() : random.log_uniform(1e-9, 1.0));
  inputs.at(0, 0).y = 0.0F;
  inputs.at(1, 0).y = 1.0F;
  const std::vector<float> outside = {
      -1e-9F, -1.0F, -1e30F, 1.0000001F, 50.0F, 1e30F, std::numeric_limits<float>::infinity()};
  for (std::size_t i = 0; i < outside.size(); ++i) inputs.at(2 + i, 0).y = outside[i];
  const Table got = run(curves, inputs);
  Bar bar("srgbEncode over [0, 1]");
  Bar clamped("toGamma");
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = static_cast<double>(inputs.at(i, 0).y);
    const bool within = c >= 0.0 && c <= 1.0;
    if (within) bar.near(static_cast<double>(got.at(i, 0).y), encode(c), 1e-6, {{"linear", c}});
    clamped.near(static_cast<double>(got.at(i, 0).w), encode(std::clamp(c, 0.0, 1.0)), 1e-6, {{"linear", c}});
  }
}

// Khronos 2024, "PBR Neutral Tone Mapper", as its specification has it.
glm::dvec3 neutral(glm::dvec3 c) {
  constexpr double start = 0.8 - 0.04;
  const double least = std::min({c.r, c.g, c.b});
  c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
  const double peak = std::max({c.r, c.g, c.b});
  if (peak < start) return c;
  const double bent = 1.0 - (1.0 - start) * (1.0 - start) / (peak + 1.0 - 2.0 * start);
  return glm::mix(c * (bent / peak), glm::dvec3(bent), 1.0 - 1.0 / (0.15 * (peak - bent) + 1.0));
}

// Reinhard et al. 2002, on luminance.
glm::dvec3 reinhard(glm::dvec3 c) {
  return c / (1.0 + glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)));
}

// Narkowicz 2016, with his exposure of 0.6.
glm::dvec3 aces(glm::dvec3 light) {
  const glm::dvec3 c = 0.6 * light;
  return (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14);
}

TEST_P(Tone, CurvesAreThoseOfTheirPapers) {
  constexpr std::size_t count = std::size_t{1} << 18;
  Random random(82);
  Table inputs(count, 1);
  for (std::size_t i = 0; i < count; ++i)
    inputs.at(i, 0) = texel({random.log_uniform(1e-4, 1e4), random.log_uniform(1e-2, 10), random.uniform()});
  struct Curve {
    const char* number;
    glm::dvec3 (*expected)(glm::dvec3);
  };
  const Curve all[] = {{"0", [](glm::dvec3 c) { return c; }}, {"1", reinhard}, {"2", aces}, {"3", neutral}};
  for (const auto& [number, expected] : all) {
    const Table got = run({.file = "tone.glsl", .outputs = 2, .defines = {{"TONE_CURVE", number}}}, inputs);
    Bar bar("tone curve " + std::string(number));
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 light(inputs.at(i, 0));
      const glm::dvec3 right = expected(light);
      for (int j = 0; j < 3; ++j)
        bar.near(got.at(i, 0)[j], right[j], 2e-6 * (1.0 + right[j]), {{"light", light[j]}, {"case", i}});
    }
  }
}

TEST_P(Tone, ScreensAreSrgbOrGamma) {
  constexpr std::size_t count = 4096;
  Table inputs(count, 1);
  for (std::size_t i = 0; i < count; ++i)
    inputs.at(i, 0) = glm::vec4(static_cast<float>(i) / (count / 1.5F) - 0.25F);
  for (const char* encoding : {"0", "1"}) {
    const Table got =
        run({.file = "tone.glsl", .outputs = 2, .defines = {{"DISPLAY_ENCODING", encoding}}}, inputs);
    Bar bar("screen's encoding " + std::string(encoding));
    for (std::size_t i = 0; i < count; ++i) {
      const double c = std::clamp(static_cast<double>(inputs.at(i, 0).x), 0.0, 1.0);
      bar.near(got.at(i, 1).y, encoding[0] == '0' ? encode(c) : std::pow(c, 1.0 / 2.2), 2e-6,
               {{"linear", inputs.at(i, 0).x}});
    }
  }
}

TEST_P(Accumulate, AConstantStaysWhatItIs) {
  const std::vector<double> constants = {0.0, 1e-6, 0.1, 0.3, 1.0 / 3.0, 0.7, 1.0, 20.0, 12345.678};
  Table inputs(constants.size(), 2);
  for (std::size_t i = 0; i < constants.size(); ++i) inputs.at(i, 0) = glm::vec4(constants[i], 10000, 0, 0);
  const Table got = run(means, inputs);
  Bar bar("accumulate, a constant after 10,000 frames");
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const auto c = static_cast<double>(inputs.at(i, 0).x);
    bar.near(static_cast<double>(got.at(i, 0).x), c, 2.0 * unit_roundoff * c, {{"constant", c}});
    EXPECT_EQ(got.at(i, 0).w, 10000.0F);
  }
}

TEST_P(Accumulate, TheMeanOfTenThousandFramesIsTheMean) {
  constexpr std::size_t pixels = 64;
  constexpr std::uint32_t frames = 10000;
  Table inputs(pixels, 2);
  for (std::size_t i = 0; i < pixels; ++i) inputs.at(i, 0) = glm::vec4(0, frames, i < 32 ? 1 : 5, 0);
  const Table got = run(means, inputs);
  // The same numbers, from their definition.
  const Probe numbers{.file = "random_numbers.glsl"};
  Table keys(pixels * frames, 1);
  for (std::size_t i = 0; i < keys.cases(); ++i) keys.at(i, 0) = glm::vec4(i / frames, 0, i % frames, 0);
  const Table xi = run(numbers, keys);
  Bar bar("accumulate, mean of 10,000 random frames against double");
  for (std::size_t i = 0; i < pixels; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < frames; ++k) sum += static_cast<double>(xi.at(i * frames + k, 0).y);
    const auto scale = static_cast<double>(inputs.at(i, 0).z);
    bar.near(static_cast<double>(got.at(i, 0).y), scale * sum / frames, 1e-5 * scale, {{"pixel", i}});
  }
}

TEST_P(Accumulate, DropsWhatIsNotANumberAndCountsIt) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec4 mean(0.25, 0.5, 1, 7);
  const std::vector<glm::vec4> bad = {{nan, 0, 0, 0},  {0, nan, 0, 0},    {0, 0, nan, 0},  {inf, 0, 0, 0},
                                      {0, 0, -inf, 0}, {0, -1e-3F, 0, 0}, {1e31F, 0, 0, 0}};
  Table inputs(bad.size() + 1, 2);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    inputs.at(i, 0) = mean;
    inputs.at(i, 1) = bad[i];
  }
  inputs.at(bad.size(), 0) = mean;
  inputs.at(bad.size(), 1) = glm::vec4(0.25, 0.5, 9, 0);
  const Table got = run(samples, inputs);
  for (std::size_t i = 0; i < bad.size(); ++i) EXPECT_EQ(got.at(i, 0), mean) << "sample " << i;
  EXPECT_EQ(got.at(bad.size(), 0), glm::vec4(0.25, 0.5, 2, 8));
}

}  // namespace
}  // namespace shadertwin::display_test

// random4 of every kind: uniform, uncorrelated, and never the same twice.
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/statistics/statistics.h"

namespace shadertwin::random_test {
namespace {

SHADERTWIN_STATISTICS(RandomNumbers);

Probe numbers_of(const char* kind, std::vector<std::pair<std::string, std::string>> more = {}) {
  more.emplace_back("RANDOM_NUMBERS", kind);
  return {.file = "random_numbers.glsl", .inputs = 1, .outputs = 1, .defines = std::move(more)};
}

const Probe numbers = numbers_of("0");

// A block of pixels at a sample and a dimension.
Table stream_keys(int first_x, std::uint32_t sample, std::uint32_t dimension) {
  Table keys(million, 1);
  for (std::size_t i = 0; i < million; ++i)
    keys.at(i, 0) = {static_cast<float>(first_x + static_cast<int>(i % 1024)), static_cast<float>(i / 1024),
                     static_cast<float>(sample), static_cast<float>(dimension)};
  return keys;
}

std::array<std::vector<double>, 4> columns(const Table& table) {
  std::array<std::vector<double>, 4> result;
  for (int j = 0; j < 4; ++j)
    result[static_cast<std::size_t>(j)] = column(table, [j](const auto& drawn) { return drawn[j]; });
  return result;
}

// Samples that a viewer reaches after a moment, a minute, an hour, a day and a year at 60 frames a second. A
// float carries them to the shader, the last one as a multiple of 128.
constexpr std::array<std::uint32_t, 5> uptimes = {0, 3600, 216000, 5184000, 1892160000};

TEST_P(RandomNumbers, StayUniformForAYear) {
  for (const std::uint32_t sample : uptimes) {
    const auto u = columns(run(numbers, stream_keys(0, sample, 2)));
    for (std::size_t j = 0; j < 4; ++j) {
      const std::string name = "sample " + std::to_string(sample) + ", number " + std::to_string(j);
      expect_uniform(name, u[j], 4099);  // a prime: numbers of few bits miss some
      expect_uniform_pairs(name + " and the next", u[j], u[(j + 1) % 4]);
      expect_uniform_pairs(name + " and the next but one", u[j], u[(j + 2) % 4]);
      expect_mean(name, u[j], 0.5, 0x1p-25);
    }
  }
}

TEST_P(RandomNumbers, NeighboursAreUncorrelated) {
  const auto here = columns(run(numbers, stream_keys(0, 5184000, 2)));
  const auto right = columns(run(numbers, stream_keys(1, 5184000, 2)));
  const auto next_sample = columns(run(numbers, stream_keys(0, 5184001, 2)));
  const auto next_dimension = columns(run(numbers, stream_keys(0, 5184000, 3)));
  for (std::size_t j = 0; j < 4; ++j) {
    const std::string name = "number " + std::to_string(j);
    expect_uncorrelated(name + ", pixel to the right", here[j], right[j]);
    expect_uncorrelated(name + ", next sample", here[j], next_sample[j]);
    expect_uncorrelated(name + ", next dimension", here[j], next_dimension[j]);
    expect_uncorrelated(name + ", pixel to the right and next sample", right[j], next_sample[j]);
    expect_uncorrelated(name + ", next sample and next dimension", next_sample[j], next_dimension[j]);
    expect_uniform_pairs(name + ", with the pixel to the right", here[j], right[j]);
    expect_uniform_pairs(name + ", with the next sample", here[j], next_sample[j]);
    const std::span<const double> all(here[j]);
    expect_uncorrelated(name + ", pixel above", all.subspan(1024), all.first(million - 1024));
    expect_uncorrelated(name + ", number " + std::to_string((j + 1) % 4), here[j], here[(j + 1) % 4]);
  }
}

// RANDOM_NUMBERS 2 is the report's: a float seed has few values, so that pixels share them. Coarse cells
// only.
TEST_P(RandomNumbers, EverySeedHasNumbersOfItsOwn) {
  for (const char* kind : {"0", "1", "2"}) {
    const auto seeded = [&](const char* seed) {
      return columns(run(numbers_of(kind, {{"SEED", seed}}), stream_keys(0, 3600, 2)));
    };
    const auto first = seeded("0");
    const auto second = seeded("1");
    for (std::size_t j = 0; j < 4; ++j) {
      const std::string name = "RANDOM_NUMBERS " + std::string(kind) + ", number " + std::to_string(j);
      EXPECT_NE(first[j], second[j]) << name;
      expect_uncorrelated(name + ", another seed", first[j], second[j]);
      if (std::string(kind) == "2") {
        expect_uniform(name, std::span(first[j]).first(1 << 16), 256);
        continue;
      }
      expect_uniform(name + ", another seed", second[j], 4096);
      expect_uniform_pairs(name + ", two seeds", first[j], second[j]);
    }
  }
}

TEST_P(RandomNumbers, EveryPixelAndFrameHasNumbersOfItsOwn) {
  std::set<std::array<float, 4>> seen;
  constexpr std::size_t pixels = 1 << 17;
  std::vector<std::uint32_t> samples(uptimes.begin(), uptimes.end());
  for (const std::uint32_t power : {8U, 16U, 24U, 30U}) samples.push_back(1U << power);
  for (const std::uint32_t sample : samples) {
    const Table got = run(numbers, stream_keys(0, sample, 0));
    for (std::size_t i = 0; i < pixels; ++i)
      seen.insert({got.at(i, 0)[0], got.at(i, 0)[1], got.at(i, 0)[2], got.at(i, 0)[3]});
  }
  EXPECT_EQ(seen.size(), pixels * samples.size());
}

// What is drawn from them along one pixel: of 2^k Sobol points in a row from a multiple of 2^k on, every box
// of 2^-a by 2^-(k - a) holds one, so that chance has no part in it.
TEST_P(RandomNumbers, SobolPointsOfAPixelAreStratified) {
  constexpr int log_points = 8;
  constexpr std::size_t points = 1 << log_points;
  constexpr std::size_t pixels = 64;
  Table keys(points * pixels, 1);
  for (std::size_t i = 0; i < keys.cases(); ++i)
    keys.at(i, 0) = {static_cast<float>(i / points), 5.0F, static_cast<float>(i % points), 4.0F};
  const auto u = columns(run(numbers_of("1", {{"SOBOL_BOUNCES", "2"}}), keys));
  Bar bar("Sobol points of a pixel, boxes with exactly one");
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    for (std::size_t pair = 0; pair < 4; pair += 2)
      for (int split = 0; split <= log_points; ++split) {
        std::set<std::pair<int, int>> boxes;
        for (std::size_t i = pixel * points; i < (pixel + 1) * points; ++i)
          boxes.insert({static_cast<int>(std::ldexp(u[pair][i], split)),
                        static_cast<int>(std::ldexp(u[pair + 1][i], log_points - split))});
        bar.holds(boxes.size() == points, static_cast<double>(boxes.size()), points,
                  {{"pixel", pixel}, {"pair", pair}, {"split", split}});
      }
}

// The camera ray has dimensions 0 and 1, each surface two more.
TEST_P(RandomNumbers, SobolPointsEndWithTheirLastSurface) {
  for (const int surfaces : {0, 1, 3}) {
    const Probe points = numbers_of("1", {{"SOBOL_BOUNCES", std::to_string(surfaces)}});
    Table keys(1024, 1);
    for (std::size_t i = 0; i < keys.cases(); ++i)
      keys.at(i, 0) = {static_cast<float>(i), 3.0F, 77.0F, static_cast<float>(i % 16)};
    const Table got = run(points, keys);
    const Table independent = run(numbers, keys);
    for (std::size_t i = 0; i < keys.cases(); ++i)
      EXPECT_EQ(got.at(i, 0) == independent.at(i, 0), static_cast<int>(i % 16) >= 2 + 2 * surfaces)
          << "dimension " << i % 16 << ", SOBOL_BOUNCES " << surfaces;
  }
}

}  // namespace
}  // namespace shadertwin::random_test

// Random numbers: bit for bit what 32-bit integers in C++ give, below 1, uniform, and uncorrelated.
#include <array>
#include <cstdint>
#include <set>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/statistics.h"

namespace shadertwin {
namespace {

class Hash : public OnEveryBackend {};
SHADERTWIN_ON_EVERY_BACKEND(Hash);

constexpr std::size_t million = std::size_t{1} << 20;
const Probe words{.file = "hash.glsl", .inputs = 2, .outputs = 3};
const Probe numbers{.file = "random_numbers.glsl", .inputs = 1, .outputs = 1};

using Key = std::array<std::uint32_t, 4>;

Key pcg4d(Key v) {
  for (std::uint32_t& word : v) word = word * 1664525U + 1013904223U;
  const auto stir = [&v] {
    v[0] += v[1] * v[3];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
    v[3] += v[1] * v[2];
  };
  stir();
  for (std::uint32_t& word : v) word ^= word >> 16;
  stir();
  return v;
}

// Austin Appleby's finaliser of MurmurHash3.
std::uint32_t finalise(std::uint32_t h) {
  h = (h ^ (h >> 16)) * 0x85ebca6bU;
  h = (h ^ (h >> 13)) * 0xc2b2ae35U;
  return h ^ (h >> 16);
}

TEST_P(Hash, Pcg4dGivesTheWordsOfThirtyTwoBitIntegers) {
  Random random(1);
  std::vector<Key> keys = {{0, 0, 0, 0},
                           {~0U, ~0U, ~0U, ~0U},
                           {1, 0, 0, 0},
                           {0, 1, 0, 0},
                           {0, 0, 1, 0},
                           {0, 0, 0, 1},
                           {0x80000000U, 0x7fffffffU, 0xffffU, 0x10000U}};
  while (keys.size() < million) {
    Key key{};
    for (std::uint32_t& word : key) word = static_cast<std::uint32_t>(random.next() >> 32);
    keys.push_back(key);
  }
  Table inputs(keys.size(), 2);
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (int j = 0; j < 4; ++j) {
      const std::uint32_t word = keys[i][static_cast<std::size_t>(j)];
      inputs.at(i, 0)[j] = static_cast<float>(word & 0xffffU);
      inputs.at(i, 1)[j] = static_cast<float>(word >> 16);
    }
  const Table got = run(words, inputs);
  Bar pcg("pcg4d, words that differ");
  Bar murmur("hash32, words that differ");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto word = [&](int texel, int j) {
      return static_cast<double>(got.at(i, texel)[j]) +
             65536.0 * static_cast<double>(got.at(i, texel + 1)[j]);
    };
    const Key expected = pcg4d(keys[i]);
    for (int j = 0; j < 4; ++j)
      pcg.near(word(0, j), expected[static_cast<std::size_t>(j)], 0.0, {{"key.x", keys[i][0]}, {"word", j}});
    const double hash = static_cast<double>(got.at(i, 2)[0]) + 65536.0 * static_cast<double>(got.at(i, 2)[1]);
    murmur.near(hash, finalise(keys[i][0]), 0.0, {{"key", keys[i][0]}});
  }
}

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
    for (std::size_t i = 0; i < table.cases(); ++i)
      result[static_cast<std::size_t>(j)].push_back(static_cast<double>(table.at(i, 0)[j]));
  return result;
}

TEST_P(Hash, NumbersAreTheTopBitsOfTheHashAndBelowOne) {
  Bar bar("random4, difference from the hash's top 24 bits");
  Bar below("random4, numbers outside [0, 1)");
  const Table got = run(numbers, stream_keys(0, 7, 3));
  for (std::size_t i = 0; i < million; ++i) {
    const Key hash =
        pcg4d({static_cast<std::uint32_t>(i % 1024), static_cast<std::uint32_t>(i / 1024), 7, 3});
    for (int j = 0; j < 4; ++j) {
      const auto u = static_cast<double>(got.at(i, 0)[j]);
      bar.near(u, static_cast<double>(hash[static_cast<std::size_t>(j)] >> 8) * 0x1p-24, 0.0,
               {{"pixel", static_cast<double>(i)}, {"number", j}});
      below.holds(u >= 0.0 && u <= 1.0 - 0x1p-24, u, 1.0, {{"pixel", static_cast<double>(i)}});
    }
  }
}

// Samples that a viewer reaches after a moment, a minute, an hour and a day at 60 frames a second.
constexpr std::array<std::uint32_t, 4> uptimes = {0, 3600, 216000, 5184000};

TEST_P(Hash, NumbersStayUniformForADay) {
  for (const std::uint32_t sample : uptimes) {
    const auto u = columns(run(numbers, stream_keys(0, sample, 2)));
    for (std::size_t j = 0; j < 4; ++j) {
      const std::string name = "sample " + std::to_string(sample) + ", number " + std::to_string(j);
      expect_uniform(name, u[j], 4096);
      expect_uniform_pairs(name + " and the next", u[j], u[(j + 1) % 4]);
      expect_mean(name, u[j], 0.5, 0x1p-25);
    }
  }
}

TEST_P(Hash, NeighboursAreUncorrelated) {
  const auto here = columns(run(numbers, stream_keys(0, 5184000, 2)));
  const auto right = columns(run(numbers, stream_keys(1, 5184000, 2)));
  const auto next_sample = columns(run(numbers, stream_keys(0, 5184001, 2)));
  const auto next_dimension = columns(run(numbers, stream_keys(0, 5184000, 3)));
  for (std::size_t j = 0; j < 4; ++j) {
    const std::string name = "number " + std::to_string(j);
    expect_uncorrelated(name + ", pixel to the right", here[j], right[j]);
    expect_uncorrelated(name + ", next sample", here[j], next_sample[j]);
    expect_uncorrelated(name + ", next dimension", here[j], next_dimension[j]);
    expect_uniform_pairs(name + ", with the pixel to the right", here[j], right[j]);
    expect_uniform_pairs(name + ", with the next sample", here[j], next_sample[j]);
    const std::span<const double> all(here[j]);
    expect_uncorrelated(name + ", pixel above", all.subspan(1024), all.first(million - 1024));
    expect_uncorrelated(name + ", number " + std::to_string((j + 1) % 4), here[j], here[(j + 1) % 4]);
  }
}

// RANDOM_NUMBERS 2 is the report's, whose faults are known: its numbers only have to be others.
TEST_P(Hash, EverySeedHasNumbersOfItsOwn) {
  for (const char* kind : {"0", "1", "2"}) {
    const auto seeded = [&](const char* seed) {
      Probe probe = numbers;
      probe.defines = {{"RANDOM_NUMBERS", kind}, {"SEED", seed}};
      return columns(run(probe, stream_keys(0, 3600, 2)));
    };
    const auto first = seeded("0");
    const auto second = seeded("1");
    for (std::size_t j = 0; j < 4; ++j) {
      const std::string name = "RANDOM_NUMBERS " + std::string(kind) + ", number " + std::to_string(j);
      EXPECT_NE(first[j], second[j]) << name;
      expect_uncorrelated(name + ", another seed", first[j], second[j]);
      if (std::string(kind) == "2") continue;
      expect_uniform(name + ", another seed", second[j], 4096);
      expect_uniform_pairs(name + ", two seeds", first[j], second[j]);
    }
  }
}

TEST_P(Hash, EveryPixelAndFrameHasNumbersOfItsOwn) {
  std::set<std::array<float, 4>> seen;
  constexpr std::size_t pixels = 1 << 17;
  for (const std::uint32_t sample : uptimes) {
    const Table got = run(numbers, stream_keys(0, sample, 0));
    for (std::size_t i = 0; i < pixels; ++i)
      seen.insert({got.at(i, 0)[0], got.at(i, 0)[1], got.at(i, 0)[2], got.at(i, 0)[3]});
  }
  EXPECT_EQ(seen.size(), pixels * uptimes.size());
}

}  // namespace
}  // namespace shadertwin

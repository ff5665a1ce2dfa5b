// Random numbers: bit for bit what 32-bit integers in C++ give, and below 1. tests/statistics asks how they
// are spread.
#include <array>
#include <cstdint>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/random.h"

namespace shadertwin::hash_test {
namespace {

class Hash : public OnEveryBackend {};
SHADERTWIN_IN_DOUBLE_AT_NIGHT(Hash);

const Probe words{.file = "hash.glsl", .inputs = 2, .outputs = 3};
const Probe numbers{
    .file = "random_numbers.glsl", .inputs = 1, .outputs = 1, .defines = {{"RANDOM_NUMBERS", "0"}}};

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

TEST_P(Hash, NumbersAreTheTopBitsOfTheHashAndBelowOne) {
  Bar bar("random4, difference from the hash's top 24 bits");
  Bar below("random4, numbers outside [0, 1)");
  Table keys(million, 1);
  for (std::size_t i = 0; i < million; ++i)
    keys.at(i, 0) = {static_cast<float>(i % 1024), static_cast<float>(i / 1024), 7.0F, 3.0F};
  const Table got = run(numbers, keys);
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

// A few numbers of every kind and seed, for their bits: run() holds the twin to llvmpipe's.
TEST_P(Hash, EveryKindGivesNumbersBelowOne) {
  Table keys(1024, 1);
  for (std::size_t i = 0; i < keys.cases(); ++i)
    keys.at(i, 0) = {static_cast<float>(i), 3.0F, static_cast<float>(i * i), static_cast<float>(i % 40)};
  Bar below("random4 of every kind, numbers outside [0, 1)");
  for (const char* kind : {"1", "2"}) {
    Probe probe = numbers;
    probe.defines = {{"RANDOM_NUMBERS", kind}, {"SEED", "1"}};
    const Table got = run(probe, keys);
    for (std::size_t i = 0; i < keys.cases(); ++i)
      for (int j = 0; j < 4; ++j) {
        const auto u = static_cast<double>(got.at(i, 0)[j]);
        below.holds(u >= 0.0 && u <= 1.0 - 0x1p-24, u, 1.0, {{"case", static_cast<double>(i)}});
      }
  }
}

}  // namespace
}  // namespace shadertwin::hash_test

// Statistical tests. Inputs and the shader's numbers come from fixed seeds, so a pass is a pass for good; the
// level keeps the seeds from having to be lucky ones. SHADERTWIN_STATISTICS_SEED, which tools/statistics
// sets, chooses other seeds throughout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/shadertoy/bar.h"
#include "tests/shadertoy/random.h"

namespace shadertwin {

// One set of seeds in a million raises a false alarm somewhere in this folder. Each TEST is a family of
// judgements with an even share of that level, and Holm's step-down method holds every family to it: the
// judgements of a TEST may depend on one another, and their number needs no guess.
constexpr double family_level = 1e-6;
constexpr int families = 40;  // TESTs in the folder, at most: every run counts them
constexpr double test_level = family_level / families;

// 0, or what SHADERTWIN_STATISTICS_SEED says.
std::uint64_t reseed();
// Inputs of a test's own: others with every seed of the run.
Random draw(std::uint64_t seed);

// A test whose judgements are one family. Judges it when it ends, and adds `test, fact, p` to the table that
// SHADERTWIN_P_VALUES names, if any. Runs on llvmpipe alone: tests/shadertoy holds the twin to its bits.
class Statistics : public OnEveryBackend {
 protected:
  Statistics();
  Table run(Probe probe, const Table& inputs) const;
  void TearDown() override;
};

#define SHADERTWIN_STATISTICS(suite)  \
  class suite : public Statistics {}; \
  SHADERTWIN_ON_FIRST_BACKEND(suite)

// Adds a judgement: how likely is what was seen, or what is further off, if the fact holds?
void expect_plausible(const std::string& fact, double p);

// Holm 1979: which of the p-values a family of this level rejects.
std::vector<bool> holm(std::span<const double> p, double level);
// Fisher 1932: independent p-values of one fact, which chance spreads evenly over [0, 1], as one.
double fisher(std::span<const double> p);

// Pearson's chi-square: how likely are counts as far from `expected` as these? Cells are merged, in order,
// until each expects `pool` or more. A count in a cell that expects nothing gives 0.
double chi_square_p(std::span<const double> counts, std::span<const double> expected, double pool = 10.0);

// Values that should be uniform on [0, 1): chi-square over `cells` cells.
void expect_uniform(const std::string& fact, std::span<const double> values, int cells = 1024);

// Pairs that should be uniform on the unit square: chi-square over cells x cells cells.
void expect_uniform_pairs(const std::string& fact, std::span<const double> xs, std::span<const double> ys,
                          int cells = 64);

// What `of`, called with a texel of each case's results as a glm::dvec4, makes of it.
template <class Of>
std::vector<double> column(const Table& results, Of of, int texel = 0) {
  std::vector<double> values(results.cases());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = of(glm::dvec4(results.at(i, texel)));
  return values;
}

struct Mean {
  double value = 0.0;
  double sigma = 0.0;  // standard error of value
  std::size_t count = 0;
};

Mean mean_of(std::span<const double> values);

// Student's t: the mean is `expected`, give or take `slack` (the error of the expectation itself).
void expect_mean(const std::string& fact, std::span<const double> values, double expected,
                 double slack = 0.0);
void expect_mean(const std::string& fact, const Mean& mean, double expected, double slack = 0.0);
// One-sided.
void expect_at_most(const std::string& fact, const Mean& mean, double bound);
void expect_at_least(const std::string& fact, const Mean& mean, double bound);

// So many of n independent trials succeed, each with probability `expected`.
void expect_share(const std::string& fact, double successes, double n, double expected);

// Two samples of one length are uncorrelated.
void expect_uncorrelated(const std::string& fact, std::span<const double> xs, std::span<const double> ys);

// Welch 1947: two independent estimates of one quantity. 1 if neither varies and they are the same.
double welch_p(const Mean& a, const Mean& b);

// Integral over [a, b], adaptive Gauss and Kronrod, relative error about 1e-10 for smooth functions.
double integrate(const std::function<double(double)>& f, double a, double b);

}  // namespace shadertwin

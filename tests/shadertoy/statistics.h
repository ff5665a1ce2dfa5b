// Statistical tests. Inputs are drawn from fixed seeds, so a pass is a pass for good; the levels keep the
// seeds from having to be lucky ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace shadertwin {

// The suite as a whole raises a false alarm once in a million sets of seeds (Bonferroni over its tests).
constexpr double family_level = 1e-6;
constexpr int tests_in_family = 300;
constexpr double test_level = family_level / tests_in_family;
constexpr double test_sigmas = 5.92;  // two-sided normal quantile of test_level

// Pearson's chi-square: how likely are counts as far from `expected` as these? Cells are merged, in order,
// until each expects `pool` or more. A count in a cell that expects nothing gives 0.
double chi_square_p(std::span<const double> counts, std::span<const double> expected, double pool = 10.0);

// Fails the current test, with `fact` and p, if p is below test_level.
void expect_plausible(const std::string& fact, double p);

// Values that should be uniform on [0, 1): chi-square over `cells` cells.
void expect_uniform(const std::string& fact, std::span<const double> values, int cells = 1024);

// Pairs that should be uniform on the unit square: chi-square over cells x cells cells.
void expect_uniform_pairs(const std::string& fact, std::span<const double> xs, std::span<const double> ys,
                          int cells = 64);

struct Mean {
  double value = 0.0;
  double sigma = 0.0;  // standard error of value
  std::size_t count = 0;
};

Mean mean_of(std::span<const double> values);

// The mean is within test_sigmas of expected, give or take `slack` (the error of the expectation itself).
void expect_mean(const std::string& fact, std::span<const double> values, double expected,
                 double slack = 0.0);
void expect_mean(const std::string& fact, const Mean& mean, double expected, double slack = 0.0);

// Two samples of one length are uncorrelated: |r| < test_sigmas / sqrt(n).
void expect_uncorrelated(const std::string& fact, std::span<const double> xs, std::span<const double> ys);

// Welch: two independent estimates of one quantity.
void expect_same_mean(const std::string& fact, const Mean& a, const Mean& b);

// Uniform floats of 24 bits for inputs that a test makes up itself.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ULL + 0x632be59bd9b4e019ULL) {}
  double uniform() { return static_cast<double>(next() >> 40) * 0x1p-24; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Magnitudes of all scales between low and high, both > 0.
  double log_uniform(double low, double high);
  double sign() { return (next() >> 63) ? 1.0 : -1.0; }
  std::uint64_t next();

 private:
  std::uint64_t state_;
};

// Integral over [a, b], adaptive Gauss and Kronrod, relative error about 1e-10 for smooth functions.
double integrate(const std::function<double(double)>& f, double a, double b);

}  // namespace shadertwin

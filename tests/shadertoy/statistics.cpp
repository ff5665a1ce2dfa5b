#include "tests/shadertoy/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace shadertwin {

double chi_square_p(std::span<const double> counts, std::span<const double> expected, double pool) {
  double statistic = 0.0;
  int cells = 0;
  double count = 0.0;
  double expectation = 0.0;
  double total = 0.0;
  for (const double e : expected) total += e;
  double rest = total;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] <= 0.0 && counts[i] > 0.0) return 0.0;
    count += counts[i];
    expectation += expected[i];
    rest -= expected[i];
    const bool last = i + 1 == counts.size();
    if (!last && (expectation < pool || rest < pool)) continue;
    if (expectation > 0.0) statistic += (count - expectation) * (count - expectation) / expectation;
    cells += expectation > 0.0 ? 1 : 0;
    count = expectation = 0.0;
  }
  if (cells < 2) return 1.0;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1), statistic));
}

void expect_plausible(const std::string& fact, double p) {
  EXPECT_GE(p, test_level) << fact << ": p = " << p;
}

void expect_uniform(const std::string& fact, std::span<const double> values, int cells) {
  std::vector<double> counts(static_cast<std::size_t>(cells));
  for (const double v : values) {
    ASSERT_TRUE(v >= 0.0 && v <= 1.0) << fact << ": " << v << " is outside [0, 1]";
    counts[static_cast<std::size_t>(std::min(static_cast<int>(v * cells), cells - 1))] += 1.0;
  }
  const std::vector<double> expected(counts.size(), static_cast<double>(values.size()) / cells);
  expect_plausible(fact, chi_square_p(counts, expected));
}

void expect_uniform_pairs(const std::string& fact, std::span<const double> xs, std::span<const double> ys,
                          int cells) {
  ASSERT_EQ(xs.size(), ys.size());
  std::vector<double> counts(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
  const auto cell = [cells](double v) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(v * cells), 0, cells - 1));
  };
  for (std::size_t i = 0; i < xs.size(); ++i)
    counts[cell(xs[i]) * static_cast<std::size_t>(cells) + cell(ys[i])] += 1.0;
  const std::vector<double> expected(counts.size(),
                                     static_cast<double>(xs.size()) / static_cast<double>(counts.size()));
  expect_plausible(fact, chi_square_p(counts, expected));
}

Mean mean_of(std::span<const double> values) {
  Mean mean;
  double m2 = 0.0;
  for (const double v : values) {
    ++mean.count;
    const double delta = v - mean.value;
    mean.value += delta / static_cast<double>(mean.count);
    m2 += delta * (v - mean.value);
  }
  const auto n = static_cast<double>(mean.count);
  mean.sigma = mean.count > 1 ? std::sqrt(m2 / (n - 1.0) / n) : 0.0;
  return mean;
}

void expect_mean(const std::string& fact, const Mean& mean, double expected, double slack) {
  EXPECT_LE(std::abs(mean.value - expected), test_sigmas * mean.sigma + slack)
      << fact << ": mean " << mean.value << " of " << mean.count << ", expected " << expected << ", off by "
      << std::abs(mean.value - expected) / mean.sigma << " sigma (" << mean.sigma << ")";
}

void expect_mean(const std::string& fact, std::span<const double> values, double expected, double slack) {
  expect_mean(fact, mean_of(values), expected, slack);
}

void expect_uncorrelated(const std::string& fact, std::span<const double> xs, std::span<const double> ys) {
  ASSERT_EQ(xs.size(), ys.size());
  const Mean mx = mean_of(xs);
  const Mean my = mean_of(ys);
  double xy = 0.0;
  for (std::size_t i = 0; i < xs.size(); ++i) xy += (xs[i] - mx.value) * (ys[i] - my.value);
  const auto n = static_cast<double>(xs.size());
  const double r = xy / (n * (n - 1.0) * mx.sigma * my.sigma);
  EXPECT_LT(std::abs(r), test_sigmas / std::sqrt(n))
      << fact << ": correlation " << r << " over " << n << " pairs";
}

void expect_same_mean(const std::string& fact, const Mean& a, const Mean& b) {
  const double sigma = std::hypot(a.sigma, b.sigma);
  EXPECT_LE(std::abs(a.value - b.value), test_sigmas * sigma)
      << fact << ": " << a.value << " against " << b.value << ", apart by "
      << std::abs(a.value - b.value) / sigma << " sigma (" << sigma << ")";
}

// SplitMix64.
std::uint64_t Random::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Random::log_uniform(double low, double high) {
  return low * std::pow(high / low, uniform());
}

double integrate(const std::function<double(double)>& f, double a, double b) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, a, b, 12, 1e-10);
}

}  // namespace shadertwin

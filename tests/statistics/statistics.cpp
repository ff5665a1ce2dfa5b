#include "tests/statistics/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>

namespace shadertwin {

namespace {

struct Judgement {
  std::string fact;
  double p;
};

// Of the test that is running.
std::vector<Judgement>& judgements() {
  static std::vector<Judgement> all;
  return all;
}

// Part of Student's distribution beyond t, on one side. Where nothing varies there is nothing to doubt.
double beyond(double difference, double sigma, double freedom) {
  if (std::isnan(difference) || std::isnan(sigma)) return 0.0;
  if (sigma == 0.0) return difference > 0.0 ? 0.0 : 1.0;
  return boost::math::cdf(
      boost::math::complement(boost::math::students_t(std::max(freedom, 1.0)), difference / sigma));
}

double freedom(const Mean& mean) {
  return static_cast<double>(mean.count) - 1.0;
}

}  // namespace

std::uint64_t reseed() {
  const char* text = std::getenv("SHADERTWIN_STATISTICS_SEED");
  return text ? std::strtoull(text, nullptr, 10) : 0;
}

Random draw(std::uint64_t seed) {
  return Random(seed + 1000003 * reseed());
}

Statistics::Statistics() {
  judgements().clear();
}

Table Statistics::run(Probe probe, const Table& inputs) const {
  const auto named = [](const auto& define) { return define.first == "SEED"; };
  if (std::none_of(probe.defines.begin(), probe.defines.end(), named))
    probe.defines.emplace_back("SEED", std::to_string(reseed()));
  return OnEveryBackend::run(probe, inputs);
}

void Statistics::TearDown() {
  EXPECT_LE(testing::UnitTest::GetInstance()->total_test_count(), families)
      << "more TESTs than the family level was shared among";
  const std::vector<Judgement> all = std::move(judgements());
  std::vector<double> p;
  for (const Judgement& judgement : all) p.push_back(judgement.p);
  const std::vector<bool> rejected = holm(p, test_level);
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_FALSE(rejected[i]) << all[i].fact << ": p = " << all[i].p << ", one of " << all.size()
                              << " judgements";
  const char* file = std::getenv("SHADERTWIN_P_VALUES");
  if (!file) return;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::ofstream out(file, std::ios::app);
  for (const Judgement& judgement : all)
    out << test.test_suite_name() << '.' << test.name() << '\t' << judgement.fact << '\t' << judgement.p
        << '\n';
}

void expect_plausible(const std::string& fact, double p) {
  judgements().push_back({fact, std::isnan(p) ? 0.0 : p});
}

std::vector<bool> holm(std::span<const double> p, double level) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<bool> rejected(p.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (p[order[k]] > level / static_cast<double>(p.size() - k)) break;
    rejected[order[k]] = true;
  }
  return rejected;
}

double fisher(std::span<const double> p) {
  double statistic = 0.0;
  for (const double value : p) statistic -= 2.0 * std::log(std::max(value, 1e-300));
  if (p.empty()) return 1.0;
  return boost::math::cdf(
      boost::math::complement(boost::math::chi_squared(2.0 * static_cast<double>(p.size())), statistic));
}

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
  const double difference = std::max(std::abs(mean.value - expected) - slack, 0.0);
  expect_plausible(fact + ": mean " + std::to_string(mean.value) + " +- " + std::to_string(mean.sigma) +
                       ", expected " + std::to_string(expected),
                   std::min(2.0 * beyond(difference, mean.sigma, freedom(mean)), 1.0));
}

void expect_mean(const std::string& fact, std::span<const double> values, double expected, double slack) {
  expect_mean(fact, mean_of(values), expected, slack);
}

void expect_at_most(const std::string& fact, const Mean& mean, double bound) {
  expect_plausible(fact + ": mean " + std::to_string(mean.value) + " +- " + std::to_string(mean.sigma) +
                       ", at most " + std::to_string(bound),
                   beyond(mean.value - bound, mean.sigma, freedom(mean)));
}

void expect_at_least(const std::string& fact, const Mean& mean, double bound) {
  expect_plausible(fact + ": mean " + std::to_string(mean.value) + " +- " + std::to_string(mean.sigma) +
                       ", at least " + std::to_string(bound),
                   beyond(bound - mean.value, mean.sigma, freedom(mean)));
}

void expect_share(const std::string& fact, double successes, double n, double expected) {
  const boost::math::binomial law(n, std::clamp(expected, 0.0, 1.0));
  const double below = boost::math::cdf(law, successes);
  const double above =
      successes > 0.0 ? boost::math::cdf(boost::math::complement(law, successes - 1.0)) : 1.0;
  expect_plausible(fact + ": " + std::to_string(successes / n) + ", expected " + std::to_string(expected),
                   std::min(2.0 * std::min(below, above), 1.0));
}

void expect_uncorrelated(const std::string& fact, std::span<const double> xs, std::span<const double> ys) {
  ASSERT_EQ(xs.size(), ys.size());
  const Mean mx = mean_of(xs);
  const Mean my = mean_of(ys);
  double xy = 0.0;
  for (std::size_t i = 0; i < xs.size(); ++i) xy += (xs[i] - mx.value) * (ys[i] - my.value);
  const auto n = static_cast<double>(xs.size());
  const double r = xy / (n * (n - 1.0) * mx.sigma * my.sigma);
  expect_plausible(fact + ": correlation " + std::to_string(r),
                   2.0 * beyond(std::abs(r), std::sqrt((1.0 - r * r) / (n - 2.0)), n - 2.0));
}

double welch_p(const Mean& a, const Mean& b) {
  const double va = a.sigma * a.sigma;
  const double vb = b.sigma * b.sigma;
  const double sigma = std::sqrt(va + vb);
  const double welch =
      sigma > 0.0 ? (va + vb) * (va + vb) / (va * va / freedom(a) + vb * vb / freedom(b)) : 1.0;
  return std::min(2.0 * beyond(std::abs(a.value - b.value), sigma, welch), 1.0);
}

double integrate(const std::function<double(double)>& f, double a, double b) {
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, a, b, 12, 1e-10);
}

}  // namespace shadertwin

// Errors against their bars: the worst of many cases, said with its input, what came out and what should
// have.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

#include "tests/shadertoy/probe.h"

namespace shadertwin {

constexpr double unit_roundoff = 1.0 / (1 << 24);  // of float

// One fact about one function. When it goes out of scope, it fails the test if any case was over its bar, and
// adds a line to the table of errors if the environment variable SHADERTWIN_ERROR_TABLE names a file for it.
class Bar {
 public:
  using Inputs = std::initializer_list<std::pair<const char*, double>>;

  // fact: "schlick, relative error". unit: what the largest allowed error is called, "4 u", "1e-6".
  explicit Bar(std::string fact) : fact_(std::move(fact)) {}
  ~Bar();
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  // got is within `allowed` of expected. A NaN never is; two equal infinities are.
  void near(double got, double expected, double allowed, Inputs inputs);
  void holds(bool fact, double got, double expected, Inputs inputs);

 private:
  void add(double error, double allowed, double got, double expected, Inputs inputs);

  std::string fact_;
  std::size_t cases_ = 0;
  std::size_t over_ = 0;
  double worst_ = -1.0;  // error / allowed
  double worst_error_ = 0.0;
  double worst_allowed_ = 0.0;
  std::string worst_case_;
};

// Every test of such a suite runs on every backend. A backend other than the first also has to give the first
// one's bits for whatever the test asks, unless it computes in double.
class OnEveryBackend : public testing::TestWithParam<std::string> {
 protected:
  const Backend& backend() const;
  Table run(const Probe& probe, const Table& inputs) const;
  Image play(const Take& take) const;
};

#define SHADERTWIN_ON_BACKENDS(instance, suite, names)                \
  INSTANTIATE_TEST_SUITE_P(instance, suite, testing::ValuesIn(names), \
                           [](const testing::TestParamInfo<std::string>& i) { return i.param; })

#define SHADERTWIN_ON_EVERY_BACKEND(suite) SHADERTWIN_ON_BACKENDS(, suite, backend_names())

// For functions that whole paths call: Paths and Scenes have them in double every day, and each by itself is
// a twin more to compile, which waits for the night.
#define SHADERTWIN_IN_DOUBLE_AT_NIGHT(suite)               \
  SHADERTWIN_ON_BACKENDS(, suite, single_backend_names()); \
  SHADERTWIN_ON_BACKENDS(Nightly, suite, double_backend_names())

// For tests of many variants of a shader: a twin takes seconds to compile each.
#define SHADERTWIN_ON_FIRST_BACKEND(suite)                                    \
  INSTANTIATE_TEST_SUITE_P(, suite, testing::Values(backend_names().front()), \
                           [](const testing::TestParamInfo<std::string>& i) { return i.param; })

std::vector<std::string> backend_names();
std::vector<std::string> single_backend_names();
std::vector<std::string> double_backend_names();

}  // namespace shadertwin

#include "tests/shadertoy/bar.h"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace shadertwin {

Bar::~Bar() {
  if (std::uncaught_exceptions() > 0) return;
  EXPECT_GT(cases_, 0U) << fact_ << ": no case was tried";
  EXPECT_EQ(over_, 0U) << fact_ << ": " << over_ << " of " << cases_ << " cases are over the bar. Worst, "
                       << worst_ << " times the bar: " << worst_case_;
  const char* file = std::getenv("SHADERTWIN_ERROR_TABLE");
  if (!file || cases_ == 0) return;
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  std::ofstream(file, std::ios::app) << fact_ << '\t'
                                     << (test && test->value_param() ? test->value_param() : "") << '\t'
                                     << cases_ << '\t' << worst_error_ << '\t' << worst_allowed_ << '\t'
                                     << worst_case_ << '\n';
}

void Bar::near(double got, double expected, double allowed, Inputs inputs) {
  const double error = got == expected ? 0.0 : std::abs(got - expected);
  add(std::isnan(error) ? std::numeric_limits<double>::infinity() : error, allowed, got, expected, inputs);
}

void Bar::holds(bool fact, double got, double expected, Inputs inputs) {
  add(fact ? 0.0 : 1.0, 0.0, got, expected, inputs);
}

void Bar::add(double error, double allowed, double got, double expected, Inputs inputs) {
  ++cases_;
  double ratio = error == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  if (allowed > 0.0) ratio = error / allowed;
  if (ratio > 1.0) ++over_;
  if (ratio <= worst_) return;
  worst_ = ratio;
  worst_error_ = error;
  worst_allowed_ = allowed;
  std::ostringstream text;
  text << std::setprecision(10);
  for (const auto& [name, value] : inputs) text << name << " = " << value << ", ";
  text << "got " << got << ", expected " << expected << ", error " << error << ", allowed " << allowed;
  worst_case_ = text.str();
}

const Backend& OnEveryBackend::backend() const {
  for (const Backend& backend : backends())
    if (backend.name == GetParam()) return backend;
  throw std::logic_error("no backend is called " + GetParam());
}

Table OnEveryBackend::run(const Probe& probe, const Table& inputs) const {
  return run_probe(backend(), probe, inputs);
}

Table OnEveryBackend::run(const Probe& probe, std::size_t cases) const {
  return run_probe(backend(), probe, cases);
}

Image OnEveryBackend::play(const Take& take) const {
  return run_shader(backend(), take);
}

std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  for (const Backend& backend : backends()) names.push_back(backend.name);
  return names;
}

}  // namespace shadertwin

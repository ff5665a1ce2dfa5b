#include "tests/shadertoy/bar.h"

#include <bit>
#include <cmath>
#include <cstdint>
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

namespace {

std::uint32_t bits(float value) {
  // NaN is NaN, whichever; and 0 is 0: Mesa leaves out sums with 0, which turn -0 into 0.
  if (value == 0.0F) return 0;
  return std::isnan(value) ? 0x7fc00000U : std::bit_cast<std::uint32_t>(value);
}

// The float twin has to do what the first backend does, bit for bit.
void expect_bits_of_first(const std::string& backend, const std::string& what,
                          const std::function<Table(const Backend&)>& run, const Table& got) {
  if (backend != "cpu") return;
  const Table first = run(backends().front());
  Bar bar(what + ", values whose bits are not those of " + backends().front().name);
  for (std::size_t i = 0; i < got.cases(); ++i)
    for (int texel = 0; texel < got.size(); ++texel)
      for (int j = 0; j < 4; ++j) {
        const float value = got.at(i, texel)[j];
        const float expected = first.at(i, texel)[j];
        bar.holds(bits(value) == bits(expected), static_cast<double>(value), static_cast<double>(expected),
                  {{"case", static_cast<double>(i)}, {"result", texel}, {"component", j}});
      }
}

bool is_double(const std::string& backend) {
  return backend.ends_with("double");
}

std::string name_of(const Probe& probe) {
  std::string name = probe.file + " " + std::to_string(probe.function);
  for (const auto& [key, value] : probe.defines) name += " " + key + "=" + value;
  return name;
}

}  // namespace

Table OnEveryBackend::run(const Probe& probe, const Table& inputs) const {
  Table got = run_probe(backend(), probe, inputs);
  expect_bits_of_first(
      GetParam(), name_of(probe), [&](const Backend& first) { return run_probe(first, probe, inputs); }, got);
  return got;
}

Image OnEveryBackend::play(const Take& take) const {
  Image got = run_shader(backend(), take);
  const auto table = [](const Image& image) {
    Table texels(image.rgba.size() / 4, 1);
    for (std::size_t i = 0; i < texels.cases(); ++i)
      texels.at(i, 0) = {image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2],
                         image.rgba[4 * i + 3]};
    return texels;
  };
  std::string name = take.file;
  for (const auto& [key, value] : take.defines) name += " " + key + "=" + value;
  expect_bits_of_first(
      GetParam(), name, [&](const Backend& first) { return table(run_shader(first, take)); }, table(got));
  return got;
}

std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  for (const Backend& backend : backends()) names.push_back(backend.name);
  return names;
}

std::vector<std::string> single_backend_names() {
  std::vector<std::string> names = backend_names();
  std::erase_if(names, is_double);
  return names;
}

std::vector<std::string> double_backend_names() {
  std::vector<std::string> names = backend_names();
  std::erase_if(names, [](const std::string& name) { return !is_double(name); });
  return names;
}

}  // namespace shadertwin

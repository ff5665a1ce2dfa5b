// Every built-in function against llvmpipe, bit by bit, on a million values.
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "tests/glsl/builtin_cases.h"
#include "tests/glsl/gl_draw.h"

namespace shadertwin::glsl {
namespace {

class BuiltinsOnLlvmpipe : public testing::Test {
 protected:
  static void SetUpTestSuite() { draw_ = std::make_unique<GlDraw>("llvmpipe"); }
  static void TearDownTestSuite() { draw_.reset(); }

  static void expect_equal_bits(const std::vector<BuiltinCase>& cases) {
    for (const BuiltinCase& test : cases) {
      const Deviation deviation = measure(test, std::ref(*draw_));
      EXPECT_EQ(deviation.equal, deviation.count)
          << deviation.name << " on " << deviation.domain
          << "\nfirst: " << text(deviation.first, test.domains.size())
          << "\nworst: " << text(deviation.worst, test.domains.size());
    }
  }

  static std::unique_ptr<GlDraw> draw_;
};

std::unique_ptr<GlDraw> BuiltinsOnLlvmpipe::draw_;

TEST_F(BuiltinsOnLlvmpipe, CommonFunctionsHaveItsBits) {
  expect_equal_bits(common_cases());
}
TEST_F(BuiltinsOnLlvmpipe, RootsExponentialsAndAnglesHaveItsBits) {
  expect_equal_bits(elementary_cases());
}
TEST_F(BuiltinsOnLlvmpipe, GeometryAndMatricesHaveItsBits) {
  expect_equal_bits(vector_cases());
}
TEST_F(BuiltinsOnLlvmpipe, IntegersHaveItsBits) {
  expect_equal_bits(integer_cases());
}

}  // namespace
}  // namespace shadertwin::glsl

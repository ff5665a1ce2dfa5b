// Every built-in function against llvmpipe, bit by bit, on a million values.
#include <gtest/gtest.h>

#include "tests/glsl/builtin_cases.h"
#include "tests/glsl/gl_draw.h"

namespace shadertwin::glsl {
namespace {

class BuiltinsOnLlvmpipe : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    draw_ =
        new Draw([draw = std::make_shared<GlDraw>("egl")](const std::string& shader, int width, int height) {
          return (*draw)(shader, width, height);
        });
  }
  static void TearDownTestSuite() { delete draw_; }

  static void expect_equal_bits(const std::vector<BuiltinCase>& cases) {
    for (const BuiltinCase& test : cases) {
      const Deviation deviation = measure(test, *draw_);
      EXPECT_EQ(deviation.equal, deviation.count)
          << deviation.name << " on " << deviation.domain
          << "\nfirst: " << text(deviation.first, test.domains.size())
          << "\nworst: " << text(deviation.worst, test.domains.size());
    }
  }

 private:
  static Draw* draw_;
};

Draw* BuiltinsOnLlvmpipe::draw_ = nullptr;

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

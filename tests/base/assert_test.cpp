#undef NDEBUG  // as in a debug build
#include "host/base/assert.h"

#include <gtest/gtest.h>

namespace shadertwin {
namespace {

TEST(AssertDeathTest, PrintsTheConditionItsValuesAndItsPlace) {
  const int width = 3;
  const std::size_t bytes = 16;
  EXPECT_DEATH(SHADERTWIN_ASSERT(width > 3), R"(assert_test\.cpp:[0-9]+: this should hold: width > 3)");
  EXPECT_DEATH(SHADERTWIN_ASSERT_EQ(width, 4), R"(this should hold: width == 4 \(3 and 4\))");
  EXPECT_DEATH(SHADERTWIN_ASSERT_LT(bytes, 16U), R"(bytes < 16U \(16 and 16\))");
}

TEST(Assert, LetsThroughWhatHoldsAndEvaluatesItOnce) {
  int count = 0;
  SHADERTWIN_ASSERT(++count == 1);
  SHADERTWIN_ASSERT_EQ(++count, 2);
  SHADERTWIN_ASSERT_LE(count, 2);
  EXPECT_EQ(count, 2);
}

}  // namespace
}  // namespace shadertwin

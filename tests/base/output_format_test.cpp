#include "host/base/output_format.h"

#include <gtest/gtest.h>

#include <array>

namespace shadertwin {
namespace {

struct Row : OutputFormat {
  int bits;
};
constexpr std::array<Row, 3> table = {{{{".png", "8 bits"}, 8}, {{".jpg", ""}, 8}, {{".exr", "floats"}, 32}}};

TEST(OutputFormat, IsFoundByTheExtensionWhateverItsCase) {
  ASSERT_NE(find_format(table, "a/b.ExR"), nullptr);
  EXPECT_EQ(find_format(table, "a/b.ExR")->bits, 32);
  EXPECT_EQ(find_format(table, "png"), nullptr);
  EXPECT_EQ(find_format(table, "a.png.txt"), nullptr);
}

TEST(OutputFormat, ListsAreForPeople) {
  EXPECT_EQ(list_of(output_formats(table)), ".png, .jpg or .exr");
  EXPECT_EQ(list_of(output_formats(table), true), ".png (8 bits), .jpg or .exr (floats)");
  EXPECT_EQ(list_of({}), "");
}

}  // namespace
}  // namespace shadertwin

#include "host/view/live_uniforms.h"

#include <gtest/gtest.h>

namespace shadertwin::view {
namespace {

CustomUniform number(const std::string& name, float value) {
  CustomUniform uniform;
  uniform.name = name;
  uniform.value[0] = value;
  return uniform;
}

TEST(LiveUniforms, WhatAHandSetOutlivesAReloadAndTheRestFollowsTheShader) {
  LiveUniforms live;
  live.declare({number("speed", 1.0F), number("size", 2.0F)});
  live.set({{7.5F}, {2.0F}});
  live.declare({number("size", 3.0F), number("speed", 1.0F), number("extra", 4.0F)});
  ASSERT_EQ(live.values().size(), 3U);
  EXPECT_EQ(live.values()[0][0], 3.0F);
  EXPECT_EQ(live.values()[1][0], 7.5F);
  EXPECT_EQ(live.values()[2][0], 4.0F);
}

TEST(LiveUniforms, AnotherTypeTakesItsOwnValue) {
  LiveUniforms live;
  live.declare({number("speed", 1.0F)});
  live.set({{7.5F}});
  CustomUniform integer = number("speed", 2.0F);
  integer.type = UniformType::int1;
  live.declare({integer});
  EXPECT_EQ(live.values()[0][0], 2.0F);
}

TEST(LiveUniforms, ResetGivesTheShadersValuesBack) {
  LiveUniforms live;
  live.declare({number("speed", 1.0F)});
  EXPECT_EQ(live.edits_as_options(), "");
  live.set({{7.5F}});
  EXPECT_EQ(live.edits_as_options(), "-D speed=7.5");
  live.reset();
  EXPECT_EQ(live.values()[0][0], 1.0F);
  EXPECT_EQ(live.edits_as_options(), "");
}

}  // namespace
}  // namespace shadertwin::view

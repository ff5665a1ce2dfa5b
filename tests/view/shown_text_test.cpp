#include "host/view/shown_text.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace shadertwin::view {
namespace {

CustomUniform uniform(const std::string& name, UniformType type) {
  CustomUniform u;
  u.name = name;
  u.type = type;
  return u;
}

TEST(UniformsAsOptions, WritesGlslLiterals) {
  EXPECT_EQ(uniforms_as_options({uniform("speed", UniformType::float1), uniform("tint", UniformType::float3),
                                 uniform("count", UniformType::int1), uniform("grid", UniformType::int2)},
                                {{2.5F}, {0.25F, 1.0F, 1e-9F}, {7.0F}, {3.0F, -4.0F}}),
            "-D speed=2.5 -D 'tint=vec3(0.25, 1.0, 1e-09)' -D count=7 -D 'grid=ivec2(3, -4)'");
}

TEST(UniformsAsOptions, FloatsReadBackBitForBit) {
  for (const float value : {0.1F, 1.0F / 3.0F, 16777216.0F, 1.17549435e-38F, -123.456F}) {
    const std::string text = uniforms_as_options({uniform("x", UniformType::float1)}, {{value}});
    EXPECT_EQ(std::strtof(text.substr(text.find('=') + 1).c_str(), nullptr), value) << text;
  }
}

TEST(Quoted, ProtectsWhatAShellWouldTouch) {
  EXPECT_EQ(quoted("a/b.glsl"), "a/b.glsl");
  EXPECT_EQ(quoted("my file.glsl"), "'my file.glsl'");
  EXPECT_EQ(quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(quoted(""), "''");
}

TEST(CommandsForPixel, RepeatTheFrameOfAFixedClock) {
  Frame frame;
  frame.width = 64;
  frame.height = 36;
  frame.index = 4;
  frame.mouse = {3, 4, 3, -4};
  EXPECT_EQ(commands_for_pixel({"a.glsl", "-D K=2", 24.0, 1.5}, frame, "Buffer A", {5, 6}),
            "shadertwin debug a.glsl --size 64x36 --fps 24 --frames 5 --time 1.5 --mouse 3,4,down --pass "
            "'Buffer A' "
            "-D K=2 --pixel 5,6\n"
            "shadertwin compare a.glsl --size 64x36 --fps 24 --frames 5 --time 1.5 --mouse 3,4,down --pass "
            "'Buffer A' -D K=2 --on auto --on cpu\n");
}

TEST(CommandsForPixel, TakeOneFrameAtTheTimeOfALiveClock) {
  Frame frame;
  frame.time = 2.125;
  frame.index = 99;
  EXPECT_EQ(commands_for_pixel({"a.glsl", "", 0.0, 0.0}, frame, "", {0, 0}),
            "shadertwin debug a.glsl --size 640x360 --time 2.125 --pixel 0,0\n"
            "shadertwin compare a.glsl --size 640x360 --time 2.125 --on auto --on cpu\n");
}

TEST(CommandsForPixel, GiveTheDateOfTheFrameIfOneWasAskedFor) {
  Frame frame;
  frame.time = 3602.5;
  const Date date = Date::parse("2025-12-31T23:30:00");
  EXPECT_TRUE(
      commands_for_pixel({"a.glsl", "", 0.0, 2.0, date}, frame, "", {0, 0})
          .starts_with("shadertwin debug a.glsl --size 640x360 --time 3602.5 --date 2026-01-01T00:30:00.5 "));
  EXPECT_TRUE(
      commands_for_pixel({"a.glsl", "", 30.0, 0.0, date}, frame, "", {0, 0})
          .starts_with(
              "shadertwin debug a.glsl --size 640x360 --fps 30 --frames 1 --date 2025-12-31T23:30:00 "));
  // What `debug` has by itself needs no saying.
  EXPECT_TRUE(commands_for_pixel({"a.glsl", "", 30.0, 0.0, Date()}, frame, "", {0, 0})
                  .starts_with("shadertwin debug a.glsl --size 640x360 --fps 30 --frames 1 --pixel"));
}

}  // namespace
}  // namespace shadertwin::view

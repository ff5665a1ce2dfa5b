#include "host/project/directives.h"

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace shadertwin {
namespace {

using Kind = Directive::Kind;

Directive only(const std::string& text) {
  const std::vector<Directive> all = parse_directives(text, "x.glsl");
  EXPECT_EQ(all.size(), 1U) << text;
  return all.empty() ? Directive{} : all.front();
}

std::string problem(const std::string& text) {
  try {
    parse_directives(text, "x.glsl");
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::shader);
    return error.what();
  }
  return "none";
}

TEST(Directives, TakePathsInBothQuotes) {
  EXPECT_EQ(only("#include \"a b.glsl\"").text, "a b.glsl");
  EXPECT_EQ(only("#include 'a.glsl'").text, "a.glsl");
  EXPECT_EQ(only("#iChannel3 \"file://x.png\" // why").text, "file://x.png");
  EXPECT_EQ(only("#iChannel0 \"..\\tex\\a.png\"").text, "..\\tex\\a.png");
  EXPECT_EQ(only("#iChannel0 \"a\\\"b.png\"").text, "a\"b.png");
}

TEST(Directives, KnowTheirChannelAndLine) {
  const Directive directive = only("\n\n  #iChannel7\n\n \"a.png\"");
  EXPECT_EQ(directive.kind, Kind::channel);
  EXPECT_EQ(directive.channel, 7);
  EXPECT_EQ(directive.line, 3);
}

TEST(Directives, MayStandBehindCodeOnTheirLine) {
  EXPECT_EQ(only("int a; #iKeyboard").kind, Kind::keyboard);
}

TEST(Directives, AreIgnoredInComments) {
  EXPECT_TRUE(parse_directives("// #include \"a\"\n/* #iChannel0 \"b\" */", "x").empty());
}

TEST(Directives, AreTakenInsideOfConditionals) {
  EXPECT_EQ(only("#if 0\n#include \"a\"\n#endif").kind, Kind::include);
}

TEST(Directives, NeedTheirHashBesideTheWord) {
  EXPECT_TRUE(parse_directives("# iKeyboard\n#iKeyboards\n#define iKeyboard", "x").empty());
}

TEST(Directives, AnApostropheInAMessageSwallowsNothing) {
  EXPECT_EQ(only("#error don't\n#iKeyboard\n").kind, Kind::keyboard);
}

TEST(Directives, WithoutArgumentsWorkAtTheEndOfTheFile) {
  EXPECT_EQ(only("#StrictCompatibility").kind, Kind::strict_compatibility);
  EXPECT_EQ(only("#iFirstPersonControls").kind, Kind::first_person_controls);
  EXPECT_EQ(only("#iVertex \"v.glsl\"").kind, Kind::vertex);
  EXPECT_EQ(only("#version 300 es").kind, Kind::version);
}

TEST(ChannelSettings, AreAllUnderstood) {
  EXPECT_EQ(only("#iChannel0::MinFilter \"NearestMipMapLinear\"").min, MinFilter::nearest_mipmap_linear);
  EXPECT_EQ(only("#iChannel0::MinFilter \"LinearMipMapNearest\"").min, MinFilter::linear_mipmap_nearest);
  EXPECT_EQ(only("#iChannel0::MinFilter \"NearestMipMapNearest\"").min, MinFilter::nearest_mipmap_nearest);
  EXPECT_EQ(only("#iChannel0::MinFilter \"LinearMipMapLinear\"").min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(only("#iChannel0::MinFilter \"Nearest\"").min, MinFilter::nearest);
  EXPECT_EQ(only("#iChannel0::MagFilter \"Nearest\"").mag, MagFilter::nearest);
  EXPECT_EQ(only("#iChannel9 :: WrapMode 'Mirror'").wrap, Wrap::mirror);
  EXPECT_EQ(only("#iChannel0::WrapMode \"Clamp\"").wrap, Wrap::clamp);
  EXPECT_TRUE(only("#iChannel0::Type \"CubeMap\"").cubemap);
  EXPECT_FALSE(only("#iChannel0::Type \"Texture2D\"").cubemap);
}

TEST(ChannelSettings, AreCaseSensitiveAndQuoted) {
  EXPECT_EQ(problem("\n#iChannel0::WrapMode \"clamp\""),
            "x.glsl:2: error: WrapMode can't be \"clamp\": it is one of Repeat, Clamp, Mirror");
  EXPECT_EQ(problem("#iChannel0::MagFilter Linear"),
            "x.glsl:1: error: expected a value in quotes, not 'Linear'");
  EXPECT_EQ(problem("#iChannel0::minfilter \"Linear\""),
            "x.glsl:1: error: unknown setting 'minfilter' of a channel: there are MinFilter, MagFilter, "
            "WrapMode, Type");
}

TEST(Directives, BrokenOnesNameTheirLine) {
  EXPECT_EQ(problem("\n#include common.glsl\n"), "x.glsl:2: error: expected a path in quotes, not 'common'");
  EXPECT_EQ(problem("\n\n#include \"common.glsl\n"), "x.glsl:3: error: the quote is not closed");
  EXPECT_EQ(problem("#iChannel0"), "x.glsl:1: error: expected a path in quotes, not the end of the file");
  EXPECT_EQ(problem("#iChannel12 \"a.png\""),
            "x.glsl:1: error: #iChannel12: the channels are iChannel0 to iChannel9");
  EXPECT_EQ(problem("#iChannel \"a.png\""),
            "x.glsl:1: error: #iChannel: the channels are iChannel0 to iChannel9");
  EXPECT_EQ(problem("#iChannel0 \"\""), "x.glsl:1: error: #iChannel0: the path is empty");
  EXPECT_EQ(problem("#iVertex"), "x.glsl:1: error: expected a path in quotes, not the end of the file");
}

TEST(CustomUniforms, TakeEveryType) {
  const CustomUniform speed = only("#iUniform float speed = -1.5e1 in { -20, 2.0 } step 0.1").uniform;
  EXPECT_EQ(speed.name, "speed");
  EXPECT_EQ(speed.type, UniformType::float1);
  EXPECT_FLOAT_EQ(speed.value[0], -15.0F);
  EXPECT_TRUE(speed.has_range);
  EXPECT_FLOAT_EQ(speed.min[0], -20.0F);
  EXPECT_FLOAT_EQ(speed.max[0], 2.0F);
  EXPECT_FLOAT_EQ(speed.step[0], 0.1F);
  const CustomUniform tint = only("#iUniform color3 tint = color3(1.0, 0.5, 0)").uniform;
  EXPECT_TRUE(tint.is_color);
  EXPECT_EQ(tint.type, UniformType::float3);
  EXPECT_EQ(tint.value, (std::array<float, 4>{1.0F, 0.5F, 0.0F, 0.0F}));
  const CustomUniform cells = only("#iUniform ivec2 cells = ivec2(3, 4) in [0, ivec2(8, 9)]").uniform;
  EXPECT_EQ(cells.type, UniformType::int2);
  EXPECT_EQ(cells.value, (std::array<float, 4>{3.0F, 4.0F, 0.0F, 0.0F}));
  EXPECT_EQ(cells.max, (std::array<float, 4>{8.0F, 9.0F, 0.0F, 0.0F}));
  EXPECT_EQ(cells.step[1], 1.0F);
}

TEST(CustomUniforms, ScalarsStandForAllComponents) {
  const std::array<float, 4> halves = {0.5F, 0.5F, 0.5F, 0.0F};
  EXPECT_EQ(only("#iUniform vec3 v = 0.5").uniform.value, halves);
  EXPECT_EQ(only("#iUniform vec3 v = vec3(0.5)").uniform.value, halves);
  EXPECT_EQ(only("#iUniform color3 v = 0.5 in {0, 1} step 0.5").uniform.step, halves);
}

TEST(CustomUniforms, WithoutADefaultStartAtTheMinimum) {
  EXPECT_FLOAT_EQ(only("#iUniform float x in {0.25, 1}").uniform.value[0], 0.25F);
}

TEST(CustomUniforms, LeaveAFollowingDeclarationAlone) {
  const std::string text = "#iUniform float x = 1.0\nin vec2 uv;";
  EXPECT_EQ(text.substr(only(text).end), "\nin vec2 uv;");
}

TEST(CustomUniforms, BrokenOnesNameTheirLine) {
  EXPECT_EQ(problem("#iUniform float x"), "x.glsl:1: error: #iUniform x: needs a default value or a range");
  EXPECT_EQ(problem("#iUniform int x = 1.5"), "x.glsl:1: error: #iUniform: an integer is needed");
  EXPECT_EQ(problem("#iUniform vec2 x = vec3(1, 2, 3)"),
            "x.glsl:1: error: #iUniform: 'vec3' is not a value of type vec2");
  EXPECT_EQ(problem("#iUniform vec3 x = vec3(1, 2)"), "x.glsl:1: error: #iUniform: vec3 takes 3 values");
  EXPECT_EQ(problem("#iUniform vec2 x = vec2(1, 2, 3)"), "x.glsl:1: error: #iUniform: vec2 takes 2 values");
  EXPECT_EQ(problem("#iUniform float x = 0.0 in {1.0, 0.0}"),
            "x.glsl:1: error: #iUniform: the range ends below its start");
  EXPECT_EQ(problem("#iUniform float x in {0.0 1.0}"), "x.glsl:1: error: expected ',', not '1.0'");
  EXPECT_EQ(problem("#iUniform float = 1.0"), "x.glsl:1: error: #iUniform: expected a name, not '='");
  EXPECT_EQ(problem("#iUniform float x = 1e99"), "x.glsl:1: error: #iUniform: expected a number, not '1e99'");
  EXPECT_EQ(problem("#iUniform float x = 1.0 step 0.0"), "x.glsl:1: error: #iUniform: a step is above 0");
  EXPECT_NE(problem("#iUniform bool x = 1").find("#iUniform: expected a type"), std::string::npos);
}

}  // namespace
}  // namespace shadertwin

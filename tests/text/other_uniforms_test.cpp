#include "host/text/other_uniforms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/text/load.h"
#include "host/text/text_warnings.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

class OtherUniforms : public testing::Test {
 protected:
  Project load(const std::string& text, Dialect dialect = Dialect::vscode) const {
    return load_project(folder.write("a.glsl", text), {.dialect = dialect});
  }
  // The warnings without the folder in front of them.
  std::vector<std::string> warnings(const std::string& text, Dialect dialect = Dialect::vscode) const {
    std::vector<std::string> all = all_warnings(load(text, dialect));
    for (std::string& line : all) line = line.substr(line.find("a.glsl"));
    return all;
  }
  TempFolder folder;
};

constexpr const char* image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";
constexpr const char* own_main = "void main() { gl_FragColor = vec4(1.0); }\n";

TEST_F(OtherUniforms, NothingSetsWhatNoHostIsKnownFor) {
  const std::vector<std::string> expected = {"a.glsl:2: warning: nothing sets the uniform 'speed'",
                                             "a.glsl:2: warning: nothing sets the uniform 'weights'",
                                             "a.glsl:3: warning: nothing sets the uniform 'picture'"};
  const std::string text =
      "uniform float time;\nuniform float speed, weights[3];\nuniform sampler2D picture;\n";
  EXPECT_EQ(warnings(text + own_main), expected);
  EXPECT_EQ(warnings("uniform struct { float x; vec2 y; } light;\n" + std::string(image)),
            (std::vector<std::string>{"a.glsl:1: warning: nothing sets the uniform 'light'"}));
}

TEST_F(OtherUniforms, ADeclarationOfAnotherTypeIsNotTheHosts) {
  EXPECT_EQ(warnings(std::string("uniform vec4 time; uniform vec3 mouse;\n") + own_main).size(), 2U);
}

TEST_F(OtherUniforms, BesideMainImageOnlyTheExtensionSetsThree) {
  const std::string text = "uniform float time;\nuniform float u_time;\n";
  EXPECT_EQ(warnings(text + image),
            (std::vector<std::string>{"a.glsl:2: warning: nothing sets the uniform 'u_time'"}));
  EXPECT_EQ(warnings(text + image, Dialect::shadertoy).size(), 2U);
}

TEST_F(OtherUniforms, OnesOwnOfTheHostsAreLeftAlone) {
  EXPECT_TRUE(warnings(std::string("uniform vec3 iResolution; uniform float iTime;\nuniform vec4 iMouse;\n"
                                   "uniform sampler2D iChannel0; uniform vec3 iChannelResolution[4];\n"
                                   "#iUniform float knob = 1.0\n") +
                       image)
                  .empty());
  EXPECT_TRUE(warnings(std::string("void f(in vec2 time, in float mouse) { }\n") + image).empty());
}

TEST_F(OtherUniforms, ABlockIsToldOnceForItsPass) {
  const std::string text = "\nuniform Light {\n  vec4 colour;\n} light;\nuniform Other { float x; };\n";
  EXPECT_EQ(warnings(text + image), (std::vector<std::string>{"a.glsl:2: warning: nothing fills the uniform "
                                                              "block 'Light': the pass is not drawn"}));
  const PassSource source = load(text + image).passes[0].source;
  EXPECT_EQ(source.body.substr(0, source.body.find("void mainImage")),
            "\nstruct Light {\nvec4 colour;\n}; uniform Light light;\n   uniform float x; \n");
  // What is none is the compiler's to refuse.
  EXPECT_TRUE(warnings("uniform Light { vec4 colour; } 1;\n" + std::string(image)).empty());
  EXPECT_TRUE(warnings("uniform Light { vec4 colour;\n" + std::string(image)).empty());
}

TEST_F(OtherUniforms, InputsAreVariablesWithoutAVertexShader) {
  const std::string text =
      "in vec2 vUv;\nflat in highp ivec2 cell, cells[2];\nlayout(location = 1) centroid\nin mat2[2] m;\n"
      "in struct Ray { vec3 o; } ray;\n";
  const std::vector<std::string> expected = {"a.glsl:2: warning: no vertex shader sets the input 'cell'",
                                             "a.glsl:2: warning: no vertex shader sets the input 'cells'",
                                             "a.glsl:4: warning: no vertex shader sets the input 'm'",
                                             "a.glsl:5: warning: no vertex shader sets the input 'ray'"};
  EXPECT_EQ(warnings(text + own_main), expected);
  std::string body = load(text + own_main).passes[0].source.body;
  std::erase(body, ' ');
  EXPECT_EQ(body.substr(0, body.find("voidmain")),
            "vec2vUv;\nivec2cell,cells[2];\n\nmat2[2]m;\nstructRay{vec3o;}ray;\n");
  // Beside mainImage() no host is known for vUv either.
  EXPECT_EQ(warnings(std::string("in vec2 vUv;\n") + image).size(), 1U);
}

TEST_F(OtherUniforms, SkippedCodeDeclaresNothing) {
  EXPECT_TRUE(warnings(std::string("#if 0\nuniform float speed;\n#endif\n") + image).empty());
}

TEST_F(OtherUniforms, LinesStay) {
  const std::string text =
      "uniform\n  float\n  time;\nuniform sampler2D backbuffer;\n" + std::string(own_main);
  const PassSource source = load(text).passes[0].source;
  EXPECT_EQ(std::count(source.body.begin(), source.body.end(), '\n'),
            std::count(text.begin(), text.end(), '\n'));
  EXPECT_NE(source.body.find("main() { time = iTime;"), std::string::npos) << source.body;
}

TEST_F(OtherUniforms, BackbufferTakesAFreeChannel) {
  const Pass pass = load(
                        "#iChannel9 \"self\"\nuniform sampler2D backbuffer;\nvoid main() { gl_FragColor = "
                        "texture2D(backbuffer, vec2(0.5)) + texture2D(iChannel9, vec2(0.5)); }\n")
                        .passes[0];
  EXPECT_EQ(pass.inputs[8].pass, 0);
  EXPECT_NE(pass.source.body.find("shadertwin_byte(texture(iChannel8, vec2(0.5)))"), std::string::npos)
      << pass.source.body;
}

// GLSL Sandbox's own template has it behind the precision.
TEST_F(OtherUniforms, TextsOfEs100AskForExtensionsAnywhere) {
  const std::string text = "precision mediump float;\n#extension GL_OES_standard_derivatives : require\n";
  const PassSource source = load(text + own_main).passes[0].source;
  EXPECT_EQ(source.refused, "");
  EXPECT_EQ(source.body.find("#extension"), std::string::npos) << source.body;
  EXPECT_NE(load(text + image).passes[0].source.refused, "");
}

TEST_F(OtherUniforms, InitialisersMoveToMainInTextsOfEs100Alone) {
  const std::string globals =
      "uniform float speed;\nfloat a = 1.0, b =\n  a * speed;\nconst float c = 2.0;\n";
  const std::string body = load(globals + own_main).passes[0].source.body;
  EXPECT_NE(body.find("a = 1.0"), std::string::npos) << body;
  EXPECT_NE(body.find("main() { b = a * speed;"), std::string::npos) << body;
  EXPECT_NE(body.find("\nconst float c = 2.0"), std::string::npos) << body;
  EXPECT_EQ(std::count(body.begin(), body.end(), '\n'), 5);
  const std::string later = load(globals + image).passes[0].source.body;
  EXPECT_NE(later.find("a * speed;\nconst"), std::string::npos) << later;
}

TEST_F(OtherUniforms, CommonThatNeedsAPassIsAWarning) {
  const TempFolder tabs;
  tabs.write("image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x)); }\n");
  tabs.write("common.glsl", "#define T iTime\n\nfloat wave(float x) {\n  return x * T;\n}\n");
  const auto told = all_warnings(load_project(tabs.path()));
  ASSERT_EQ(told.size(), 1U) << "one line, the first";
  EXPECT_NE(told[0].find("common.glsl:4: warning: "), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("shadertoy.com compiles Common by itself"), std::string::npos) << told[0];
  // What every pass lacks is an error of theirs.
  tabs.write("common.glsl", "float wave(float x) {\n  return 1;\n}\n");
  EXPECT_TRUE(all_warnings(load_project(tabs.path())).empty());
  tabs.write("common.glsl", "float wave(float x) { return x + iDate.x + iSampleRate; }\n");
  EXPECT_TRUE(all_warnings(load_project(tabs.path())).empty());
  // A function of the pass's own, and a tab that ends in the middle of something.
  tabs.write("common.glsl", "float later();\nfloat wave(float x) { return later(); }\n");
  tabs.write("image.glsl", "float later() { return 1.0; }\n" + std::string(image));
  EXPECT_EQ(all_warnings(load_project(tabs.path())).size(), 1U);
  for (const auto& [begin, end] : std::vector<std::pair<std::string, std::string>>{
           {"const float one =", "1.0;"}, {"/*", "*/"}, {"#if 1", "#endif"}, {"#define F(x) x\nF(", ")"}}) {
    tabs.write("common.glsl", begin + "\n");
    tabs.write("image.glsl", end + "\n" + image);
    EXPECT_EQ(all_warnings(load_project(tabs.path())).size(), 1U) << begin;
  }
  // The name of its output there.
  tabs.write("common.glsl", "const float outColor = 1.0;\n");
  tabs.write("image.glsl", image);
  EXPECT_EQ(all_warnings(load_project(tabs.path())).size(), 1U);
}

}  // namespace
}  // namespace shadertwin

// `shadertwin check` as a user types it: each kind of finding in a planted shader, at its line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/image/image.h"
#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

class CheckCommand : public testing::Test {
 protected:
  // What check says about an image shader whose first line is `before` and whose third is `statements`.
  Outcome check(const std::string& before, const std::string& statements, const std::string& options = "") {
    folder.write("a.glsl", before + "\nvoid mainImage(out vec4 c, in vec2 p) {\n" + statements + "\n}\n");
    return run(folder, "check a.glsl --size 8x4 " + options);
  }
  ScratchFolder folder;
};

// The only finding starts with `text`.
void expect_only(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.out.rfind(text, 0), 0U) << outcome.out << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1) << outcome.out;
}

TEST_F(CheckCommand, IsSilentAboutASoundShader) {
  const Outcome outcome = check("float half_of(float x) { return 0.5 * x; }", "c = vec4(half_of(p.x));");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CheckCommand, TellsEveryErrorOfTheLanguageAtItsLine) {
  const Outcome outcome =
      check("float one() { return 1; }", "float a = 1;\nfloat b = a * 2;\nc = vec4(a, b, one(), q);");
  EXPECT_EQ(outcome.status, 1);
  for (const char* line :
       {"a.glsl:1: webgl2: ", "\na.glsl:3: webgl2: ", "\na.glsl:4: webgl2: ", "\na.glsl:5: webgl2: "})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << '\n' << outcome.out;
  EXPECT_EQ(outcome.err, "shadertwin: a.glsl: 4 findings\n");
}

TEST_F(CheckCommand, FindsWhatOnlyBrowsersRefuse) {
  expect_only(check("float my__name = 1.0;", "c = vec4(my__name);"), "a.glsl:1: webgl2: 'my__name'");
  expect_only(check("", "float webgl_x = p.x;\nc = vec4(webgl_x);"), "a.glsl:3: webgl2: 'webgl_x'");
  expect_only(check("float f() { return 1.0; };", "c = vec4(f());"), "a.glsl:1: webgl2: semicolon");
  expect_only(
      check("float f() { return 1.0; }\n#extension GL_OES_standard_derivatives : enable", "c = vec4(f());"),
      "a.glsl:2: webgl2: #extension");
}

TEST_F(CheckCommand, FindsLoopsWithoutAWayOutAndDoesNotRunThem) {
  expect_only(check("", "float x = 0.0;\nfor (;;) { x += 1.0; for (;;) break; }\nc = vec4(x);"),
              "a.glsl:4: webgl2: no break or return leaves this loop");
  expect_only(check("", "c = p.xyxy;\nfor (;;) { if (p.x > 1.0) discard; }"),
              "a.glsl:4: webgl2: no break or return leaves this loop");
  expect_only(check("", "c = p.xyxy;\ndo c.x += 1.0; while (true);"),
              "a.glsl:4: loop: nothing leaves this loop");
  const Outcome left =
      check("", "float x = 0.0;\nwhile (true) { x += 1.0; if (x > 3.0) break; }\nc = vec4(x);");
  EXPECT_EQ(left.status, 0) << left.out << left.err;
}

TEST_F(CheckCommand, FindsLoopsWhoseConditionNothingChanges) {
  const std::string text = "loop: no round of this loop changes its condition";
  for (const std::string loop :
       {"bool on = p.x > -1.0; while (on) {}", "bool on = true; do c.x += 1.0; while (on);",
        "int i = 0; while (i < 10) c.x += 1.0;", "for (int i = 0; i < 10; i += 0) c.x += 1.0;",
        "for (float x = 1.0; x < 2.0; x *= 1.0) c.x += x;", "for (int i = 0, n = 0; i < 3; ++n) c.x += 1.0;",
        "float y = p.y; while (y > -1.0) { y = y; c.x += 1.0; }", "while (more()) c.x += 1.0;",
        "int a = 0; for (; a < 5;) { int a = 9; a += 1; }",
        "while (p.x > -1.0) { if (c.x > 5.0) c.x = 0.0; c.x += 1.0; }",
        "uint u = 1u; while (u != 0u) u <<= 0;", "bool on = true; while (c.x += 1.0, on) {}"})
    expect_only(check("bool on_ = true; bool more() { return on_; }", "c = vec4(0.0);\n" + loop),
                "a.glsl:4: " + text);
}

TEST_F(CheckCommand, LeavesLoopsThatChangeTheirConditionAlone) {
  const Outcome outcome = check("int k = 0; int next() { return ++k; } void step_(inout int n) { n += 2; }",
                                "c = vec4(0.0); int i = 0, n = 0; bool on = true, off = p.x < -1.0;\n"
                                "while (on) { c.x += 1.0; on = c.x < 3.0; }\n"
                                "on = true; while (on) { if (c.x++ > 3.0) break; }\n"
                                "while (i++ < 10) c.x += 1.0;\n"
                                "for (float x = 1.0; x < 9.0; x *= 2.0) c.x += x;\n"
                                "while (n < 5) step_(n);\n"
                                "while (next() < 4) c.x += 1.0;\n"
                                "while (off) return;\n"
                                "bool never = false; while (never) c.x += 1.0;\n"
                                "int list[2] = int[2](0, 0); while (list[0] < 4) list[0] += 1;\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, FindsVersionsInTabs) {
  folder.write("tabs/image.glsl",
               "#version 300 es\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
  expect_only(run(folder, "check tabs --size 8x4"),
              "tabs/image.glsl:1: webgl2: #version is shadertoy.com's own");
  folder.write(
      "toy.json",
      R"({"Shader": {"ver": "0.1", "info": {"id": "x"}, "renderpass": [{"type": "image", "name": "Image",
      "inputs": [], "outputs": [], "code": "\n#version 300 es\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }"}]}})");
  expect_only(run(folder, "check toy.json --size 8x4"), "toy.json:Image:2: webgl2: ");
  expect_only(check("#version 300 es", "c = vec4(1.0);"),
              "a.glsl:1: portability: #version is shadertoy.com's own");
  expect_only(check("\n#version 300 es", "c = vec4(1.0);"),
              "a.glsl:2: webgl2: the VS Code extension refuses a #version");
  expect_only(check("#define V #version 300 es\n#if 0\n#version 100\n#else\n#version 300 es\n#endif",
                    "c = vec4(1.0);"),
              "a.glsl:5: webgl2: the VS Code extension refuses a #version");
}

TEST_F(CheckCommand, FindsMacrosThatPreprocessorsExpandDifferently) {
  expect_only(check("#define ID(x) x\n#define iTime (iTime + 2.0)", "c = vec4(ID(iTime));"),
              "a.glsl:4: portability: macro 'iTime' names itself");
  // By way of another one.
  expect_only(check("#define ID(x) x\n#define iTime (later * 2.0)\n#define later (iTime + 1.0)",
                    "c = vec4(ID(iTime));"),
              "a.glsl:5: portability: macro 'iTime' names itself");
  expect_only(check("#define take(x) x\n#define open take((1.0)", "c = vec4(open));"),
              "a.glsl:2: portability: macro 'open' opens an invocation");
  expect_only(check("#define TWICE(x) (2.0 * (x))", "c = vec4(TWICE(\n#if 1\n1.0\n#endif\n));"),
              "a.glsl:4: portability: a directive between the arguments of macro 'TWICE'");
  const Outcome fine = check("#define ID(x) x\n#define max(a, b) max(a, float(b))\n#define two() ID((2.0))",
                             "c = vec4(max(1.0, 0) * ID(two()));");
  EXPECT_EQ(fine.status, 0) << fine.out << fine.err;
}

constexpr const char* functions_with_effects =
    "int n = 0; int next() { return ++n; } float doubled(inout float x) { x *= 2.0; return x; } void "
    "add(inout "
    "float a, float b) { a += b; } float pair(int a, int b) { return float(a + b); } void late(int a, inout "
    "int b) { b += a; } "
    "float[2] numbers() { ++n; return float[2](1.0, 2.0); } float[2] pure() { return float[2](1.0, 2.0); }";

TEST_F(CheckCommand, FindsWhatDependsOnTheOrderOfEvaluation) {
  const auto changed_late = [](const std::string& name) {
    return "'" + name + "' is read and then changed in one expression";
  };
  const auto taken_in = [](const std::string& name) {
    return "'" + name + "' is passed as `inout` while another argument changes it";
  };
  const std::vector<std::pair<std::string, std::string>> statements = {
      {"c.x = pair(i, i++);", changed_late("i")},
      {"c.x = float(i + i++);", changed_late("i")},
      {"a[k] = float(k++);", changed_late("k")},
      {"add(x, doubled(x));", taken_in("x")},
      {"c.x = float(n * next());", changed_late("n")},
      {"x += doubled(x);", changed_late("x")},
      {"c.xy = vec2(x, doubled(x));", changed_late("x")},
      {"c.x = a[k] + float(k = 1);", changed_late("k")},
      {"late(next(), n);", taken_in("n")},
      {"c.x = float(numbers().length());", "a call with effects of which only length() is taken"}};
  std::string text = "c = vec4(0.0); int i = 1, k = 0; float x = p.x; float a[3] = float[3](1.0, 2.0, 3.0);";
  for (const auto& [statement, words] : statements) text += '\n' + statement;
  const Outcome outcome = check(functions_with_effects, text);
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const auto& [statement, words] = statements[i];
    EXPECT_NE(outcome.out.find("a.glsl:" + std::to_string(i + 4) + ": portability: " + words),
              std::string::npos)
        << statement << '\n'
        << outcome.out;
  }
}

TEST_F(CheckCommand, LeavesOrdersThatAreTheTextsAlone) {
  const Outcome outcome = check(functions_with_effects,
                                "c = vec4(0.0); int i = 1; float x = 1.0; float a[2] = float[2](1.0, 2.0);\n"
                                "c.x = float(i++); c.y = float(i);\n"
                                "c.xy = vec2(doubled(x), doubled(x));\n"
                                "float z = doubled(c.x), y = (x = 2.0, x); c.x = y + z;\n"
                                "bool b = i++ < 1 && i == 1; c.x = b ? float(i++) : float(i);\n"
                                "x = doubled(x); c.x = x;\n"
                                "i = 0; c.x = a[i++] + a[0] + float(pair(i++, i));\n"
                                "c.x = length(c = c * 2.0) - c.x + float(pure().length());\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, FindsVariablesThatAreTooLargeTogether) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "float a" + std::to_string(i) + "[16000];\n";
  text += "void mainImage(out vec4 c, in vec2 p) {\n  c = vec4(0);\n";
  for (int i = 0; i < 300; ++i) text += "  c.x += a" + std::to_string(i) + "[int(p.x)];\n";
  folder.write("m.glsl", text + "}\n");
  const Outcome outcome = run(folder, "check m.glsl --size 8x4 --frames 1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("webgl2: the variables have more than 16 MB together: browsers refuse it"),
            std::string::npos)
      << outcome.out << outcome.err;
}

TEST_F(CheckCommand, FindsUniformsOfOtherHosts) {
  folder.write(
      "m.frag",
      "uniform float u_time;\nuniform float speed;\nvoid main() { gl_FragColor = vec4(u_time + speed); }\n");
  const Outcome outcome = run(folder, "check m.frag --size 8x4 --frames 1");
  EXPECT_NE(outcome.out.find("m.frag:1: portability: 'u_time' is set here as another host sets it"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("m.frag:2: portability: nothing sets the uniform 'speed'"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.err, "shadertwin: m.frag: 4 findings\n");
}

TEST_F(CheckCommand, FindsNamesOfOneHostOnly) {
  expect_only(check("", "c = vec4(saturate(p.x));"), "a.glsl:3: portability: 'saturate'");
  expect_only(check("", "c = vec4(iFrameRate);"), "a.glsl:3: portability: 'iFrameRate'");
}

TEST_F(CheckCommand, FindsWhatOnlyTheExtensionHas) {
  const std::vector<std::string> uses = {"texture2D(iChannel0, p)", "textureCube(iChannel1, p.xyx)",
                                         "texture(iKeyboard, p)",   "vec4(isKeyDown(65))",
                                         "vec4(isKeyPressed(65))",  "vec4(isKeyToggled(65))",
                                         "vec4(isKeyReleased(65))", "iMouseButton",
                                         "iViewMatrix[0]",          "vec4(iGlobalTime)",
                                         "vec4(iGlobalFrame)",      "texture(iChannel4, p)"};
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
    write_image(Image(1, 1), folder / ("sky_" + std::string(face) + ".png"));
  std::string statements = "c = vec4(0.0);";
  for (const std::string& use : uses) statements += "\nc += " + use + ";";
  const Outcome outcome =
      check("#iKeyboard\n#iChannel1 \"sky_{}.png\"\n#iChannel1::Type \"CubeMap\"", statements, "--frames 1");
  for (std::size_t i = 0; i < uses.size(); ++i)
    EXPECT_NE(outcome.out.find("a.glsl:" + std::to_string(i + 6) + ": portability: '"), std::string::npos)
        << uses[i] << '\n'
        << outcome.out << outcome.err;
  folder.write("m.glsl", "void main() { gl_FragColor = vec4(1.0); }\n");
  const Outcome own = run(folder, "check m.glsl --size 8x4 --frames 1");
  EXPECT_NE(own.out.find("m.glsl:1: portability: main() is shadertoy.com's own"), std::string::npos)
      << own.out;
  EXPECT_NE(own.out.find("m.glsl:1: portability: 'gl_FragColor'"), std::string::npos) << own.out;
}

TEST_F(CheckCommand, FindsWhatOnlyTheSiteHas) {
  expect_only(check("", "c = vec4(iChannelTime[0]);", "--frames 1"), "a.glsl:3: portability: 'iChannelTime'");
  expect_only(check("", "c = vec4(HW_PERFORMANCE);", "--frames 1"),
              "a.glsl:3: portability: 'HW_PERFORMANCE'");
  folder.write("tabs/sound.glsl", "\nvec2 mainSound(int s, float t) { return vec2(t); }\n");
  folder.write("tabs/cubemap_a.glsl",
               "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) { c = vec4(d, 1.0); }\n");
  folder.write("tabs/common.glsl", "#define ONE 1.0\n\n");
  folder.write("tabs/buffer_a.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n  c = vec4(iCh0.size, ONE);\n}\n");
  folder.write("tabs/image.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n\n  c = vec4(iCh0.size, 1.0);\n}\n");
  const Outcome outcome = run(folder, "check tabs --size 8x4");
  EXPECT_NE(outcome.out.find("sound.glsl:2: portability: 'mainSound'"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("cubemap_a.glsl:1: portability: 'mainCubemap'"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("image.glsl:3: portability: 'iCh0'"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("buffer_a.glsl:2: webgl2: 'iCh0' is there in the Image pass only"),
            std::string::npos)
      << outcome.out;
}

TEST_F(CheckCommand, FindsUniformBlocks) {
  expect_only(check("uniform Light { vec4 colour; };", "c = colour;", "--frames 1"),
              "a.glsl:1: portability: nothing fills the uniform block 'Light': the pass is not drawn");
}

TEST_F(CheckCommand, FindsNamesThatAHostHasTaken) {
  expect_only(check("uniform float iTime;", "c = vec4(iTime);"),
              "a.glsl:1: portability: 'iTime' is there already");
  expect_only(check("#define saturate(x) clamp(x, 0.0, 1.0)", "c = vec4(saturate(p.x));"),
              "a.glsl:1: portability: 'saturate' is there already in the VS Code extension");
  expect_only(check("#define fragCoord p", "c = vec4(fragCoord, 0.0, 1.0);"),
              "a.glsl:1: portability: a macro");
  expect_only(check("vec3 cameraPosition = vec3(0.0);", "c = vec4(cameraPosition, 1.0);"),
              "a.glsl:1: portability: 'cameraPosition' is there already in the VS Code extension");
  const Outcome guarded = check("#ifndef saturate\n#define saturate(x) clamp(x, 0.0, 1.0)\n#endif",
                                "float viewMatrix = p.x; c = vec4(saturate(viewMatrix));");
  EXPECT_EQ(guarded.status, 0) << guarded.out << guarded.err;
}

TEST_F(CheckCommand, FindsNamesThatTheSiteHasAroundOneKindOfPass) {
  const std::string image = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";
  folder.write("tabs/image.glsl", "float outColor = 1.0;\nfloat unViewport = 1.0;\n" + image);
  folder.write("tabs/buffer_a.glsl", image);
  EXPECT_EQ(run(folder, "check tabs --size 8x4 --frames 1").status, 0);
  folder.write("tabs/buffer_a.glsl", "float iCh0 = 1.0;\nfloat outColor = 1.0;\n" + image);
  expect_only(run(folder, "check tabs --size 8x4 --frames 1"),
              "tabs/buffer_a.glsl:2: webgl2: 'outColor' is there already on shadertoy.com");
}

// As shadertoy.com compiles it: its functions see no uniforms, its macros may name them.
TEST_F(CheckCommand, ReadsCommonByItself) {
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x) + T); }\n");
  folder.write(
      "tabs/common.glsl",
      "#define T iTime\nfloat later(float x);\nfloat year() { return iDate.x + iSampleRate + later(1.0); }\n"
      "float later(float x) { return x; }\nfloat wave(float x) { return x; }\n");
  const Outcome fine = run(folder, "check tabs --size 8x4");
  EXPECT_EQ(fine.status, 0) << fine.out << fine.err;
  folder.write("tabs/common.glsl", "#define T iTime\n\nfloat wave(float x) {\n  return x * T;\n}\n");
  const Outcome outcome = run(folder, "check tabs --size 8x4 -D KNOB=1");
  expect_only(outcome, "tabs/common.glsl:4: webgl2: ");
  EXPECT_NE(
      outcome.out.find("'iTime' : undeclared identifier (shadertoy.com compiles Common by itself, too)"),
      std::string::npos)
      << outcome.out;
  folder.write(
      "tabs/image.glsl",
      "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x)); }\nfloat later(float x) { return x; }\n");
  folder.write("tabs/common.glsl", "float later(float x);\nfloat wave(float x) {\n  return later(x);\n}\n");
  expect_only(run(folder, "check tabs --size 8x4"),
              "tabs/common.glsl:3: webgl2: 'later' is called but not defined");
  const Outcome warned = run(folder, "render tabs --size 8x4 -o a.png");
  EXPECT_EQ(warned.err.rfind("tabs/common.glsl:3: warning: shadertoy.com compiles Common by itself", 0), 0U)
      << warned.err;
  EXPECT_EQ(warned.status, 0);
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(wave(p.x) + T); }\n");
  folder.write("tabs/common.glsl", "float wave(float x) {\n  return 1;\n}\n#define T 0.0\n");
  expect_only(run(folder, "check tabs --size 8x4"), "tabs/common.glsl:2: webgl2: ");
}

TEST_F(CheckCommand, LeavesTextForLocalHostsAlone) {
  const Outcome outcome = check(
      "#ifdef SHADER_TOY\nfloat f(float x) { return saturate(x); }\n#else\nfloat f(float x) { return x; "
      "}\n#endif",
      "c = vec4(f(p.x));");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(CheckCommand, FindsAnOutputThatAReturnLeavesUnwritten) {
  expect_only(
      check(
          "bool hit(float x, out float t) {\n  if (x > 2.0)\n    return false;\n  t = x;\n  return true;\n}",
          "float t = 0.0;\nc = hit(p.x, t) ? vec4(t) : vec4(0);"),
      "a.glsl:3: out: 't' of hit() is not written");
}

TEST_F(CheckCommand, FindsAnOutputThatAFunctionsEndLeavesUnwritten) {
  expect_only(check("void hit(float x, out float t) { if (x > 2.0) t = x; }",
                    "float t = 0.0;\nhit(p.x, t);\nc = vec4(0.0);"),
              "a.glsl:1: out: 't' of hit() is not written");
}

TEST_F(CheckCommand, AcceptsOutputsWrittenOnEveryPath) {
  const Outcome outcome = check(
      "void f(int i, out float t) {\n  switch (i) { case 0: t = 1.0; break; default: t = 2.0; }\n}\n"
      "void g(int i, out float t) {\n  if (i > 3) { f(i, t); return; }\n  for (int k = 0; k < 4; ++k) t = "
      "1.0;\n}",
      "float t; g(int(p.x), t);\nc = vec4(t);");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

// Undefined operations, planted in line 4. `zero` and `none` are 0, but not to a compiler.
struct Planted {
  const char* name;
  const char* statement;
  const char* kind;
  const char* text;
};

class CheckCatalogue : public CheckCommand, public testing::WithParamInterface<Planted> {};

TEST_P(CheckCatalogue, IsFoundAtItsLine) {
  const Planted& planted = GetParam();
  const Outcome outcome =
      check("", std::string("c = vec4(0.0); float zero = min(p.x, 0.0); int none = int(zero);\n") +
                    planted.statement);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find(std::string("a.glsl:4: ") + planted.kind + ": " + planted.text),
            std::string::npos)
      << outcome.out << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(
    Undefined, CheckCatalogue,
    testing::Values(
        Planted{"PowOfANegative", "c.x = pow(p.x - 4.0, 2.0);", "undefined", "pow() of a negative base"},
        Planted{"SqrtOfANegative", "c.x = sqrt(p.x - 4.0);", "undefined", "sqrt() of a negative"},
        Planted{"LogOfANegative", "c.x = log(p.x - 4.0);", "undefined", "log() or log2()"},
        Planted{"AcosBeyondOne", "c.x = acos(p.x);", "undefined", "acos()"},
        Planted{"AsinBeyondOne", "c.x = asin(p.x);", "undefined", "asin()"},
        Planted{"AtanOfZeros", "c.x = atan(zero, zero);", "undefined", "atan(0, 0)"},
        Planted{"NormalizeOfZero", "c.xyz = normalize(vec3(zero));", "undefined", "normalize()"},
        Planted{"DivisionByZero", "c.x = p.x / zero;", "undefined", "division by zero"},
        Planted{"DivisionInPlace", "c /= zero;", "undefined", "division by zero"},
        Planted{"IntegerDivision", "c.x = float(3 / none);", "undefined", "integer division by zero"},
        Planted{"IndexOutOfBounds", "float a[3] = float[3](1.0, 2.0, 3.0); c.x = a[none + 3];", "undefined",
                "index out"},
        Planted{"ClampCrossed", "c.x = clamp(p.x, 1.0, zero);", "undefined", "clamp()"},
        Planted{"ShiftOutOfRange", "c.x = float(1 << (none + 32));", "undefined", "shift"},
        Planted{"ModByZero", "c.x = mod(p.x, zero);", "undefined", "mod()"},
        Planted{"SmoothstepCrossed", "c.x = smoothstep(1.0, zero, p.x);", "undefined", "smoothstep()"},
        Planted{"Infinity", "c.x = exp2(200.0 + p.x);", "inf", "infinity first appears"},
        Planted{"NotANumber", "float big = exp2(200.0 + p.x) - exp2(200.0 + p.x); c.x = big;", "nan",
                "NaN first appears"},
        Planted{"EndlessLoop", "for (int i = 0; i < 70000 + none; ++i) c.x += 1.0;", "loop",
                "loops of more than 65534"}),
    [](const auto& planted) { return std::string(planted.param.name); });

TEST_F(CheckCommand, CountsPixelsAndNamesTheFirstAndItsPass) {
  expect_only(
      check("", "c = vec4(p.x < 4.0 ? 0.0 : clamp(p.y, 9.0, 8.0 - p.x));", "--frames 1"),
      "a.glsl:3: undefined: clamp() with a lower bound above the upper one (pass a, 16 pixels, first at "
      "4,0 in frame 0)");
}

TEST_F(CheckCommand, FindsTheLineInsideAFunctionAndBehindACall) {
  const Outcome outcome = check("float f(float x) {\n  return sqrt(x - 4.0);\n}",
                                "c = vec4(1.0);\nfloat a = f(p.x) / (p.x - p.x);\nc.x = a;");
  EXPECT_NE(outcome.out.find("a.glsl:2: undefined: sqrt()"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("a.glsl:6: undefined: division by zero"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, DoesNotBlameWhoReadsANaNFromABuffer) {
  folder.write("b.glsl", "void mainImage(out vec4 c, in vec2 p) {\n  c = vec4(exp2(200.0 + p.x));\n}\n");
  const Outcome outcome = check("#iChannel0 \"b.glsl\"", "c = texelFetch(iChannel0, ivec2(p), 0);");
  EXPECT_NE(outcome.out.find("b.glsl:2: inf: "), std::string::npos) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.find("a.glsl"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, NamesTheLineThatUsesAnUnwrittenVariable) {
  expect_only(check("", "float a;\nif (p.x > 4.0) a = 1.0;\nfloat b = 2.0;\nc = vec4(a + b);"),
              "a.glsl:6: uninitialised: a value that was never written is used (pass a, 16 pixels");
}

TEST_F(CheckCommand, NamesTheConditionThatAnUnwrittenVariableDecides) {
  expect_only(check("", "float a;\nif (p.x > 4.0) a = 1.0;\nc = vec4(0.0);\nif (a < -1.0)\n  c = vec4(1.0);"),
              "a.glsl:6: uninitialised: ");
}

TEST_F(CheckCommand, WritesItsFindingsAsJson) {
  const Outcome outcome = check("float my__name = 1.0;", "c = vec4(my__name);", "--json r.json");
  EXPECT_EQ(outcome.status, 1);
  const auto report = nlohmann::json::parse(contents(folder / "r.json"));
  ASSERT_EQ(report["findings"].size(), 1U);
  EXPECT_EQ(report["findings"][0]["file"], "a.glsl");
  EXPECT_EQ(report["findings"][0]["line"], 1);
  EXPECT_EQ(report["findings"][0]["kind"], "webgl2");
}

class CheckScenes : public testing::TestWithParam<int> {};

TEST_P(CheckScenes, AreClean) {
  const ScratchFolder folder;
  const Outcome outcome =
      run(folder, "check '" SHADERTWIN_SOURCE_DIR "/shadertoy/image.glsl' --size 32x18 -D SCENE=" +
                      std::to_string(GetParam()));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(PathTracer, CheckScenes, testing::Range(0, 5));

TEST_F(CheckCommand, KeepsOtherExitStatuses) {
  EXPECT_EQ(run(folder, "check missing.glsl").status, 4);
  EXPECT_EQ(check("", "c = vec4(1.0);", "--frames 0").status, 2);
}

}  // namespace
}  // namespace shadertwin

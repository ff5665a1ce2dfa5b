#include <gtest/gtest.h>

#include "host/project/text_file.h"
#include "host/text/load.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

std::string place(const Project& project, const Pass& pass, std::size_t line) {
  const SourceLine& source = pass.source.lines.at(line);
  const std::string file =
      source.file < 0 ? "host" : std::filesystem::path(project.files.at(source.file)).filename().string();
  return file + ":" + std::to_string(source.line);
}

TEST(LoadFile, KeepsEveryLineWhereItWas) {
  const TempFolder folder;
  const auto file = folder.write(
      "a.glsl", "#iKeyboard\n#iChannel0\n \"self\"\nint x; /* #iKeyboard */\n" + std::string(empty_image));
  const Project project = load_project(file);
  EXPECT_EQ(project.passes[0].source.written, "\n\n\nint x; /* #iKeyboard */\n" + std::string(empty_image));
  EXPECT_EQ(project.passes[0].source.body, "\n\n\nint x;\n" + std::string(empty_image));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(place(project, project.passes[0], i), "a.glsl:" + std::to_string(i + 1));
  EXPECT_TRUE(project.passes[0].keyboard);
  EXPECT_NE(project.passes[0].source.head.find("const int Key_A = 65;"), std::string::npos);
}

TEST(LoadFile, ExpandsNestedIncludesWithTheirLines) {
  const TempFolder folder;
  folder.write("lib/b.glsl", "b1\n#include 'c.glsl'\nb3");
  folder.write("lib/c.glsl",
               "\xEF\xBB\xBF"
               "c1\r\nc2\r\n");
  const auto file =
      folder.write("a.glsl", "a1 #include \"file://lib\\b.glsl\" a1b\n" + std::string(empty_image));
  const Project project = load_project(file);
  const Pass& pass = project.passes[0];
  EXPECT_EQ(pass.source.body, "a1\nb1\nc1\nc2\n\nb3\na1b\n" + std::string(empty_image));
  EXPECT_EQ(place(project, pass, 0), "a.glsl:1");
  EXPECT_EQ(place(project, pass, 1), "b.glsl:1");
  EXPECT_EQ(place(project, pass, 2), "c.glsl:1");
  EXPECT_EQ(place(project, pass, 3), "c.glsl:2");
  EXPECT_EQ(place(project, pass, 5), "b.glsl:3");
  EXPECT_EQ(place(project, pass, 6), "a.glsl:1");
  EXPECT_EQ(place(project, pass, 7), "a.glsl:2");
  EXPECT_EQ(pass.source.lines.size(), 8U);
}

TEST(LoadFile, PutsDefinesInFrontOfEveryPass) {
  const TempFolder folder;
  folder.write("b.glsl", empty_image);
  const auto file = folder.write("a.glsl", "#iChannel0 \"b.glsl\"\n" + std::string(empty_image));
  const Project project = load_project(file, {.settings = {.defines = {{"N", "4"}, {"FAST", ""}}}});
  for (const Pass& pass : project.passes) {
    EXPECT_TRUE(pass.source.written.starts_with("#define N 4\n#define FAST \n")) << pass.source.written;
    EXPECT_EQ(place(project, pass, 0), "host:0");
    EXPECT_EQ(pass.source.lines[2].line, 1);
  }
}

TEST(LoadFile, DrawsAPassAfterWhatItReads) {
  const TempFolder folder;
  folder.write("b.glsl", "#iChannel0 \"c.glsl\"\n#iChannel1 \"a.glsl\"\n" + std::string(empty_image));
  folder.write("c.glsl", "#iChannel2 \"b.glsl\"\n#iChannel3 \"self\"\n" + std::string(empty_image));
  const auto file =
      folder.write("a.glsl", "#iChannel1 \"b.glsl\"\n#iChannel0 \"./c.glsl\"\n#iChannel4 \"../" +
                                 folder.path().filename().string() + "/a.glsl\"\n" + empty_image);
  const Project project = load_project(file);
  ASSERT_EQ(project.passes.size(), 3U);
  EXPECT_EQ(project.passes[0].name, "c");
  EXPECT_EQ(project.passes[1].name, "b");
  EXPECT_EQ(project.passes[2].name, "a");
  EXPECT_EQ(project.passes[0].inputs[2].pass, 1);
  EXPECT_EQ(project.passes[0].inputs[3].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[0].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[1].pass, 2);
  EXPECT_EQ(project.passes[2].inputs[1].pass, 1);
  EXPECT_EQ(project.passes[2].inputs[0].pass, 0);
  EXPECT_EQ(project.passes[2].inputs[4].pass, 2);
  EXPECT_EQ(project.passes[1].kind, PassKind::buffer);
  EXPECT_EQ(project.passes[2].kind, PassKind::image);
}

TEST(LoadFile, SettingsBelongToOneInputInAnyOrder) {
  const TempFolder folder;
  folder.write("t.png", "");
  const auto file =
      folder.write("a.glsl",
                   "#iChannel1::WrapMode \"Clamp\"\n#iChannel1 \"t.png\"\n#iChannel2 \"t.png\"\n"
                   "#iChannel1::MinFilter \"Nearest\"\n#iChannel1::MagFilter \"Nearest\"\n" +
                       std::string(empty_image));
  const Project project = load_project(file);
  const auto& inputs = project.passes[0].inputs;
  EXPECT_EQ(inputs[1].kind, InputKind::texture);
  EXPECT_EQ(inputs[1].sampler.wrap, Wrap::clamp);
  EXPECT_EQ(inputs[1].sampler.min, MinFilter::nearest);
  EXPECT_EQ(inputs[1].sampler.mag, MagFilter::nearest);
  EXPECT_EQ(inputs[2].sampler.wrap, Wrap::repeat);
  EXPECT_EQ(inputs[2].sampler.min, MinFilter::linear);
  EXPECT_TRUE(inputs[2].sampler.vflip);
}

TEST(LoadFile, KnowsMediaByTheirExtension) {
  const TempFolder folder;
  for (const char* name : {"a.PNG", "b.mp3", "c.webm", "d.bin", "e.dds"}) folder.write(name, "");
  const auto file =
      folder.write("a.glsl",
                   "#iChannel0 'a.PNG'\n#iChannel1 'b.mp3'\n#iChannel2 'c.webm'\n#iChannel3 'd.bin'\n"
                   "#iChannel4 'e.dds'\n#iChannel5 'http://x.org/y.png'\n" +
                       std::string(empty_image));
  const Project project = load_project(file);
  const auto& inputs = project.passes[0].inputs;
  EXPECT_EQ(inputs[0].kind, InputKind::texture);
  EXPECT_EQ(inputs[1].kind, InputKind::music);
  EXPECT_EQ(inputs[2].kind, InputKind::video);
  EXPECT_EQ(inputs[3].kind, InputKind::volume);
  EXPECT_FALSE(inputs[4].sampler.vflip);
  EXPECT_EQ(inputs[5].kind, InputKind::none);
  EXPECT_NE(project.passes[0].source.head.find("uniform sampler3D iChannel3;"), std::string::npos);
  ASSERT_EQ(project.warnings.size(), 1U);
  EXPECT_NE(project.warnings[0].find("a.glsl:6: warning: \"http://x.org/y.png\" is not fetched"),
            std::string::npos);
}

TEST(LoadFile, FindsCubemapsInAllFourNamings) {
  const std::vector<std::vector<std::string>> sets = {{"e", "w", "u", "d", "n", "s"},
                                                      {"east", "west", "up", "down", "north", "south"},
                                                      {"px", "nx", "py", "ny", "pz", "nz"},
                                                      {"posx", "negx", "posy", "negy", "posz", "negz"}};
  for (const auto& set : sets)
    for (const std::string wildcard : {"{}", "*"}) {
      const TempFolder folder;
      for (const std::string& name : set) folder.write("maps/sky_" + name + ".jpg", "");
      const auto file = folder.write("a.glsl", "#iChannel2 \"file:///maps/sky_" + wildcard +
                                                   ".jpg\"\n#iChannel2::Type \"CubeMap\"\n" + empty_image);
      const Project project = load_project(file);
      const Input& input = project.passes[0].inputs[2];
      EXPECT_EQ(input.kind, InputKind::cubemap);
      ASSERT_EQ(input.files.size(), 6U);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(input.files[i].filename(), "sky_" + set[i] + ".jpg");
      EXPECT_FALSE(input.sampler.vflip);
      EXPECT_NE(project.passes[0].source.head.find("uniform samplerCube iChannel2;"), std::string::npos);
    }
}

TEST(LoadFile, NamesTheMissingFaceOfACubemap) {
  const TempFolder folder;
  for (const char* name : {"px", "nx", "py", "ny", "pz"})
    folder.write(std::string("sky_") + name + ".jpg", "");
  const auto file = folder.write(
      "a.glsl", "\n#iChannel0 \"sky_{}.jpg\"\n#iChannel0::Type \"CubeMap\"\n" + std::string(empty_image));
  EXPECT_EQ(load_error(folder, file, ExitStatus::file),
            "a.glsl:2: error: the cubemap is not complete: sky_nz.jpg is missing");
}

TEST(LoadFile, ReportsAnIncludeThatGoesInACircle) {
  const TempFolder folder;
  folder.write("b.glsl", "\n#include \"c.glsl\"");
  folder.write("c.glsl", "\n\n#include \"b.glsl\"");
  const auto file = folder.write("a.glsl", "#include \"b.glsl\"\n" + std::string(empty_image));
  EXPECT_EQ(load_error(folder, file, ExitStatus::shader),
            "c.glsl:3: error: the include goes in a circle: b.glsl -> c.glsl -> b.glsl");
  const auto self = folder.write("self.glsl", "#include \"self.glsl\"\n");
  EXPECT_EQ(load_error(folder, self, ExitStatus::shader),
            "self.glsl:1: error: the include goes in a circle: self.glsl -> self.glsl");
}

TEST(LoadFile, StopsWhenIncludesMultiply) {
  const TempFolder folder;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
    folder.write(std::to_string(i) + ".glsl", next + next);
  }
  folder.write("40.glsl", "");
  EXPECT_NE(load_error(folder, folder.path() / "0.glsl", ExitStatus::shader).find("add up to too much"),
            std::string::npos);
}

TEST(LoadFile, ReportsWhatCannotBeRead) {
  const TempFolder folder;
  EXPECT_EQ(load_error(folder, folder.path() / "no.glsl", ExitStatus::file),
            "no.glsl: error: there is no such file");
  const auto missing = folder.write("a.glsl", "\n#include \"no.glsl\"\n");
  EXPECT_TRUE(load_error(folder, missing, ExitStatus::file)
                  .starts_with("a.glsl:2: error: can't find \"no.glsl\" to include; tried no.glsl"));
  const auto texture = folder.write("b.glsl", "#iChannel0 \"no.png\"\n" + std::string(empty_image));
  EXPECT_TRUE(
      load_error(folder, texture, ExitStatus::file).starts_with("b.glsl:1: error: can't find \"no.png\""));
  std::filesystem::create_directories(folder.path() / "dir");
  const auto directory = folder.write("c.glsl", "#include \"dir\"\n");
  EXPECT_EQ(load_error(folder, directory, ExitStatus::file), "c.glsl:1: error: dir is a folder");
  const auto binary = folder.write("d.glsl", std::string("a\0b", 3));
  EXPECT_EQ(load_error(folder, binary, ExitStatus::file), "d.glsl: error: is not a text file");
}

TEST(LoadFile, NeedsAnEntryPoint) {
  const TempFolder folder;
  const auto file = folder.write("a.glsl", "// void main() {}\nfloat f() { return 1.0; }\n");
  EXPECT_EQ(load_error(folder, file, ExitStatus::shader),
            "a.glsl:1: error: there is no mainImage(out vec4, in vec2) and no main()");
  EXPECT_NE(load_error(folder, folder.write("empty.glsl", ""), ExitStatus::shader), "");
}

TEST(LoadFile, TakesEveryHonestEntryPoint) {
  const auto tail = [](const std::string& text) {
    const TempFolder folder;
    return load_project(folder.write("a.glsl", text)).passes[0].source.tail;
  };
  EXPECT_EQ(tail("void main() {}"), "");
  EXPECT_EQ(tail("void main(void)\n{}"), "");
  EXPECT_EQ(tail("void main() {} void mainImage(out vec4 o, vec2 p) {}"), "");
  EXPECT_NE(tail("void mainImage(out vec4 o, vec2 p) {}"), "");
  EXPECT_NE(tail("void mainImage( out highp vec4 o , const in highp vec2 p )\n{}"), "");
  EXPECT_NE(tail("#define M void mainImage(out vec4 o, vec2 p)\nM {}"), "");
  EXPECT_NE(tail("#StrictCompatibility\nvoid main() {} void mainImage(out vec4 o, vec2 p) {}"), "");
}

TEST(LoadFile, DropsTheVersionLine) {
  const TempFolder folder;
  const Project project =
      load_project(folder.write("a.glsl", "#version 300 es\r\n" + std::string(empty_image)));
  EXPECT_EQ(project.passes[0].source.body, "\n" + std::string(empty_image));
  EXPECT_EQ(project.passes[0].source.head.find("version"), std::string::npos);
}

TEST(LoadFile, LeavesNamesToTheUserWhoDefinesThem) {
  const TempFolder folder;
  const auto source = [&](const std::string& text) {
    return load_project(folder.write("a.glsl", text + empty_image)).passes[0].source;
  };
  const auto body = [&](const std::string& text) { return source(text).body.substr(0, text.size() + 20); };
  const auto head = [&](const std::string& text) { return source(text).head; };
  EXPECT_TRUE(body("float a = saturate(2.0);\n").starts_with("float a = clamp(2.0, 0.0, 1.0);\n"));
  const std::string own = "float saturate(float x) { return x; }\nfloat f() { return saturate(2.0); }\n";
  EXPECT_TRUE(body(own).starts_with(own)) << body(own);
  EXPECT_TRUE(body("#define saturate(x) x\nfloat a = saturate(2.0);\n").starts_with("\nfloat a = 2.0;\n"));
  EXPECT_EQ(head("uniform float iTime;\n").find("float iTime;"), std::string::npos);
  EXPECT_NE(head("float f() { return iFrameRate; }\n").find("uniform float iFrameRate;"), std::string::npos);
}

TEST(LoadFile, SharesUniformsAndRefusesTwoMeanings) {
  const TempFolder folder;
  folder.write("b.glsl", "#iUniform float x = 1.0\n" + std::string(empty_image));
  const auto same =
      folder.write("a.glsl", "#iChannel0 \"b.glsl\"\n#iUniform float x = 1.0\n" + std::string(empty_image));
  const Project project = load_project(same);
  EXPECT_EQ(project.uniforms.size(), 1U);
  for (const Pass& pass : project.passes)
    EXPECT_NE(pass.source.head.find("uniform float x;"), std::string::npos);
  const auto other =
      folder.write("c.glsl", "#iChannel0 \"b.glsl\"\n\n#iUniform vec2 x = 1.0\n" + std::string(empty_image));
  EXPECT_EQ(load_error(folder, other, ExitStatus::shader),
            "b.glsl:1: error: #iUniform x is declared differently elsewhere");
}

TEST(LoadFile, RefusesDefinesThatGlslCannotHave) {
  const TempFolder folder;
  const auto file = folder.write("a.glsl", empty_image);
  for (const char* name : {"", "1X", "A B", "F(x)", "a-b"})
    EXPECT_TRUE(load_error(folder, file, ExitStatus::usage, {.settings = {.defines = {{name, "1"}}}})
                    .starts_with("-D "))
        << name;
  EXPECT_NE(load_error(folder, file, ExitStatus::usage, {.settings = {.defines = {{"A", "1\n2"}}}}), "");
}

TEST(FindPass, ForgivesCaseSpacesAndUnderscores) {
  Project project;
  project.passes.resize(2);
  project.passes[0].name = "Buffer A";
  project.passes[1].name = "Image";
  EXPECT_EQ(find_pass(project, "buffera"), 0);
  EXPECT_EQ(find_pass(project, "BUFFER_A"), 0);
  EXPECT_EQ(find_pass(project, "image"), 1);
  EXPECT_EQ(find_pass(project, "Buffer B"), -1);
}

TEST(DisplayName, IsRelativeBelowTheWorkingFolder) {
  EXPECT_EQ(display_name(std::filesystem::current_path() / "x" / ".." / "a.glsl"), "a.glsl");
  EXPECT_EQ(display_name("./lib/a.glsl"), "lib/a.glsl");
  EXPECT_EQ(display_name("/somewhere/else.glsl"), "/somewhere/else.glsl");
}

}  // namespace
}  // namespace shadertwin

// Shaders that leave in another form and come back.
#include <gtest/gtest.h>

#include "tests/app/command_line.h"

namespace shadertwin {
namespace {

// Two passes, knobs, an include, the extension's own names and a key.
void write_shader(const ScratchFolder& folder) {
  folder.write("image.glsl",
               "#iChannel2 \"state.glsl\"\n"
               "#include \"colors.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = vec4(texelFetch(iChannel2, ivec2(p), 0).xyz * tint, 1.0);\n"
               "}\n");
  folder.write("colors.glsl", "const vec3 tint = vec3(1.0, LEVEL, saturate(2.0));\n");
  folder.write("state.glsl",
               "#iChannel0 \"self\"\n"
               "#iKeyboard\n"
               "#iUniform float speed = 0.25 in { 0.0, 1.0 }\n"
               "#ifdef SHADER_TOY\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  vec4 last = texelFetch(iChannel0, ivec2(p), 0);\n"
               "  c = last + vec4(speed, p.x / iResolution.x, isKeyDown(Key_A) ? 0.5 : 0.125, 1.0);\n"
               "}\n"
               "#endif\n");
}

std::string rendered(const ScratchFolder& folder, const std::string& shader) {
  const Outcome outcome = run(folder, "render " + shader + " --size 8x4 --frames 3 --keys a@1 -o frame.exr");
  EXPECT_EQ(outcome.status, 0) << shader << ": " << outcome.err;
  return contents(folder / "frame.exr");
}

TEST(Export, TabsPlayAsTheProjectDoes) {
  const ScratchFolder folder;
  write_shader(folder);
  const Outcome outcome = run(folder, "export image.glsl -D LEVEL=0.5 --to tabs -o tabs");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* name : {"image.glsl", "buffer_a.glsl", "common.glsl", "shadertoy.json", "BINDINGS.txt"})
    EXPECT_TRUE(std::filesystem::exists(folder / "tabs" / name)) << name;
  EXPECT_EQ(rendered(folder, "tabs"), rendered(folder, "image.glsl -D LEVEL=0.5"));
}

TEST(Export, JsonPlaysAsTheProjectDoes) {
  const ScratchFolder folder;
  write_shader(folder);
  const Outcome outcome = run(folder, "export image.glsl -D LEVEL=0.5 --to json -o toy.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(rendered(folder, "toy.json"), rendered(folder, "image.glsl -D LEVEL=0.5"));
}

TEST(Export, JsonWithKnobsKeepsWhatElseTheDocumentHeld) {
  const ScratchFolder folder;
  folder.write("toy.json",
               R"({"Shader": {"ver": "0.1", "info": {"name": "Toy", "strange": [1, {"deep": null}]},
    "renderpass": [{"type": "image", "inputs": [], "outputs": [], "name": "Image", "future": 7,
    "code": "void mainImage(out vec4 c, in vec2 p) { c = vec4(K); }"}]}})");
  ASSERT_EQ(run(folder, "export toy.json -D K=2 --to json -o with.json").err, "");
  EXPECT_NE(contents(folder / "with.json").find("\"strange\""), std::string::npos);
  EXPECT_NE(contents(folder / "with.json").find("\"future\""), std::string::npos);
  EXPECT_EQ(rendered(folder, "with.json"), rendered(folder, "toy.json -D K=2"));
}

TEST(Export, TabsAreTextsWithoutDirectives) {
  const ScratchFolder folder;
  write_shader(folder);
  ASSERT_EQ(run(folder, "export image.glsl -D LEVEL=0.5 --to tabs -o tabs").status, 0);
  for (const char* name : {"image.glsl", "buffer_a.glsl", "common.glsl"}) {
    const std::string text = contents(folder / "tabs" / name);
    for (const char* directive : {"#iChannel", "#include", "#iUniform", "#iKeyboard"})
      EXPECT_EQ(text.find(directive), std::string::npos) << name << ": " << text;
  }
}

TEST(Export, NoShaderCanEndThePagesScript) {
  const ScratchFolder folder;
  folder.write("image.glsl", "// </script><b>\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
  const Outcome outcome = run(folder, "export image.glsl --to html -o page.html");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(contents(folder / "page.html").find("</script><b>"), std::string::npos);
}

// Each pass becomes a program that draws the pixel (3, 1) of 8x4, with nothing on its channels: opaque black.
TEST(Export, CppCompilesAndDraws) {
  const ScratchFolder folder;
  write_shader(folder);
  const Outcome outcome = run(folder, "export image.glsl -D LEVEL=0.5 --to cpp -o cpp");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  folder.write("draw.cpp", R"(
#include PASS
#include <cstdio>
int main() {
  using namespace shadertwin::twin;
  Description description;
  shadertwin_describe(&description);
  if (description.abi != abi_version) return 1;
  const float resolution[3] = {8, 4, 1};
  const float speed = 0.25F;
  const UniformValue uniforms[] = {{"iResolution", UniformValue::Kind::float32, resolution, 3},
                                   {"speed", UniformValue::Kind::float32, &speed, 1}};
  const bool stop = false;
  float pixel[4] = {};
  Request request;
  request.uniforms = uniforms;
  request.uniform_count = 2;
  request.x0 = 3;
  request.y0 = 1;
  request.x1 = 4;
  request.y1 = 2;
  request.pixels = pixel;
  request.row_pitch = 4;
  request.stop = &stop;
  shadertwin_render(&request);
  std::printf("%g %g %g %g", pixel[0], pixel[1], pixel[2], pixel[3]);
})");
  const auto draw = [&](const std::string& pass) {
    const std::string command = "cd '" + folder.path().string() +
                                "' && c++ -std=c++20 -ffp-contract=off -w -I'" SHADERTWIN_SOURCE_DIR
                                "' -DPASS='\"cpp/" +
                                pass + ".cpp\"' draw.cpp -o draw && ./draw >drawn";
    EXPECT_EQ(std::system(command.c_str()), 0) << contents(folder / "cpp" / (pass + ".cpp"));
    return contents(folder / "drawn");
  };
  EXPECT_EQ(draw("state"), "0.25 0.4375 0.125 2");  // 3.5 / 8, and no key is held
  EXPECT_EQ(draw("image"), "0 0 0 1");
}

TEST(Export, AFolderThatIsThereStaysAsItIs) {
  const ScratchFolder folder;
  write_shader(folder);
  folder.write("tabs/mine.txt", "mine");
  const Outcome outcome = run(folder, "export image.glsl -D LEVEL=0.5 --to tabs -o tabs");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  EXPECT_EQ(contents(folder / "tabs" / "mine.txt"), "mine");
}

TEST(Export, WhatTheSiteLacksIsSaidInOneLineAndLeavesNothing) {
  const ScratchFolder folder;
  folder.write(
      "five.glsl",
      "#iChannel7 \"other.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel7, p); }\n");
  folder.write("other.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n");
  for (const char* form : {"tabs -o tabs", "json -o toy.json"}) {
    const Outcome outcome = run(folder, std::string("export five.glsl --to ") + form);
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
  }
  const auto files = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace shadertwin

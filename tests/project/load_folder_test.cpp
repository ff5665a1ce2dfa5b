#include <gtest/gtest.h>

#include "host/text/load.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

TEST(LoadFolder, DrawsTabsInOrderWithCommonInFront) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("Buffer_B.glsl", empty_image);
  folder.write("buffer a.frag", empty_image);
  folder.write("COMMON.glsl", "float f;");
  folder.write("readme.md", "no tab");
  const Project project = load_project(folder.path());
  EXPECT_EQ(project.dialect, Dialect::shadertoy);
  ASSERT_EQ(project.passes.size(), 3U);
  EXPECT_EQ(project.passes[0].name, "Buffer A");
  EXPECT_EQ(project.passes[1].name, "Buffer B");
  EXPECT_EQ(project.passes[2].name, "Image");
  EXPECT_EQ(project.passes[2].kind, PassKind::image);
  EXPECT_EQ(project.passes[0].kind, PassKind::buffer);
  for (const Pass& pass : project.passes) {
    EXPECT_EQ(pass.source.body, "float f;\n" + std::string(empty_image));
    ASSERT_EQ(pass.source.lines.size(), 2U);
    EXPECT_TRUE(project.files[pass.source.lines[0].file].ends_with("COMMON.glsl"));
    EXPECT_EQ(pass.source.lines[1].line, 1);
  }
}

TEST(LoadFolder, OnlyTheImageIsOpaque) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("buffer_a.glsl", empty_image);
  const Project project = load_project(folder.path());
  EXPECT_EQ(project.passes[0].source.head.find("1.0); }"), std::string::npos);
  EXPECT_NE(project.passes[1].source.head.find("vec4(shadertoy_color.rgb, 1.0)"), std::string::npos);
}

TEST(LoadFolder, BindsChannelsByDirectivesInFilesThatAlsoPaste) {
  const TempFolder folder;
  folder.write("common.glsl", "float f;\n");
  folder.write("image.glsl",
               "#ifdef SHADER_TOY\n#include \"common.glsl\"\n#iChannel1 \"buffer_a.glsl\"\n#endif\n" +
                   std::string(empty_image));
  folder.write("buffer_a.glsl", "#iChannel0 \"self\"\n" + std::string(empty_image));
  const Project project = load_project(folder.path());
  EXPECT_EQ(project.passes[0].inputs[0].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[1].pass, 0);
  // Common is there already: the include adds nothing, and the site knows no SHADER_TOY.
  EXPECT_EQ(project.passes[1].source.body, "float f;\n\n\n\n\n" + std::string(empty_image));
  EXPECT_EQ(project.passes[1].source.head.find("SHADER_TOY"), std::string::npos);
}

TEST(LoadFolder, BindsChannelsByItsSettings) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("buffer_a.glsl", empty_image);
  folder.write("tex/wood.png", "");
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
    folder.write(std::string("sky_") + face + ".png", "");
  folder.write("shadertoy.json", R"({
    "Image": {"iChannel0": {"buffer": "Buffer A", "filter": "mipmap", "wrap": "repeat", "vflip": false},
              "iChannel1": {"texture": "tex/wood.png"},
              "iChannel3": {"keyboard": true}},
    "buffer_a": {"iChannel2": {"cubemap": "sky_{}.png", "filter": "nearest"}}})");
  const Project project = load_project(folder.path());
  const auto& image = project.passes[1].inputs;
  EXPECT_EQ(image[0].kind, InputKind::pass);
  EXPECT_EQ(image[0].pass, 0);
  EXPECT_EQ(image[0].sampler.min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(image[0].sampler.wrap, Wrap::repeat);
  EXPECT_FALSE(image[0].sampler.vflip);
  EXPECT_EQ(image[1].kind, InputKind::texture);
  EXPECT_TRUE(image[1].sampler.vflip);
  EXPECT_EQ(image[3].kind, InputKind::keyboard);
  EXPECT_EQ(image[3].sampler.mag, MagFilter::nearest);
  const Input& sky = project.passes[0].inputs[2];
  EXPECT_EQ(sky.kind, InputKind::cubemap);
  EXPECT_EQ(sky.files.size(), 6U);
  EXPECT_EQ(sky.sampler.min, MinFilter::nearest);
}

TEST(LoadFolder, FindsTabsByTheirShortNames) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("bufA.glsl", empty_image);
  folder.write("buf_d.frag", empty_image);
  folder.write("cubemap.glsl", "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {}\n");
  std::vector<std::string> names;
  for (const Pass& pass : load_project(folder.path()).passes) names.push_back(pass.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Buffer A", "Buffer D", "Cubemap A", "Image"}));
}

TEST(LoadFolder, BindsAPassThatItLacksByTheKindOfIt) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("shadertoy.json", R"({"Image": {"iChannel0": {"missing pass": "cubemap"},
                                               "iChannel1": {"missing pass": "buffer"}}})");
  const Pass pass = load_project(folder.path()).passes[0];
  EXPECT_EQ(pass.inputs[0].kind, InputKind::undrawn);
  EXPECT_EQ(pass.inputs[0].undrawn, PassKind::cubemap);
  EXPECT_EQ(pass.inputs[1].undrawn, PassKind::buffer);
  EXPECT_NE(pass.source.head.find("uniform samplerCube iChannel0;"), std::string::npos);
  EXPECT_NE(pass.source.head.find("uniform sampler2D iChannel1;"), std::string::npos);
  folder.write("shadertoy.json", R"({"Image": {"iChannel0": {"missing pass": "sound"}}})");
  EXPECT_EQ(load_error(folder, folder.path(), ExitStatus::file),
            "shadertoy.json: error: Image.iChannel0.missing pass is no kind of pass that is read: \"sound\"");
}

TEST(LoadFolder, ReportsBrokenSettings) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("wood.png", "");
  const auto error = [&](const std::string& json) {
    folder.write("shadertoy.json", json);
    return load_error(folder, folder.path(), ExitStatus::file);
  };
  EXPECT_EQ(error("{\n\"Image\": {"), "shadertoy.json:2: error: this is not JSON: the text ends too early");
  EXPECT_EQ(error("{\n\"Image\" 5}"),
            "shadertoy.json:2: error: this is not JSON: unexpected text in column 9");
  EXPECT_EQ(error("[]"), "shadertoy.json: error: the document is not an object");
  EXPECT_EQ(error(R"({"Imag": {}})"), "shadertoy.json: error: there is no tab \"Imag\"");
  EXPECT_EQ(error(R"({"Image": {"iChannel4": {}}})"),
            "shadertoy.json: error: \"iChannel4\" is not one of iChannel0 to iChannel3");
  EXPECT_EQ(error(R"({"Image": {"iChannel0": {"texture": 5}}})"),
            "shadertoy.json: error: Image.iChannel0.texture is not a string");
  EXPECT_EQ(error(R"({"Image": {"iChannel0": {"texture": "no.png"}}})"),
            "shadertoy.json: error: there is no file \"no.png\" in the folder");
  EXPECT_EQ(error(R"({"Image": {"iChannel0": {"texture": "wood.png", "filter": "cubic"}}})"),
            "shadertoy.json: error: Image.iChannel0.filter is one of nearest, linear, mipmap");
  EXPECT_EQ(error(R"({"Image": {"iChannel0": {"buffer": "Buffer D"}}})"),
            "shadertoy.json: error: there is no tab \"Buffer D\"");
  EXPECT_EQ(error(std::string(100000, '[')), "shadertoy.json: error: over 64 levels of JSON");
}

TEST(LoadFolder, OpensNothingOutsideOfItself) {
  const TempFolder folder;
  folder.write("secret.png", "");
  folder.write("toy/image.glsl", empty_image);
  std::filesystem::create_symlink(folder.path() / "secret.png", folder.path() / "toy/link.png");
  const auto error = [&](const std::string& path) {
    folder.write("toy/shadertoy.json", R"({"Image": {"iChannel0": {"texture": ")" + path + "\"}}}");
    return load_error(folder, folder.path() / "toy", ExitStatus::file);
  };
  EXPECT_NE(error("../secret.png").find("climbs out of its folder"), std::string::npos);
  EXPECT_NE(error("..\\\\secret.png").find("climbs out of its folder"), std::string::npos);
  EXPECT_NE(error((folder.path() / "secret.png").string()).find("is an absolute path"), std::string::npos);
  EXPECT_NE(error("link.png").find("leads out"), std::string::npos);
  EXPECT_NE(error("https://x.org/a.png").find("nothing is fetched"), std::string::npos);
}

TEST(LoadFolder, NeedsAnImage) {
  const TempFolder folder;
  folder.write("toy/buffer_a.glsl", empty_image);
  EXPECT_EQ(load_error(folder, folder.path() / "toy", ExitStatus::file),
            "toy: error: the folder has no image.glsl");
}

TEST(LoadFolder, RefusesTwoFilesForOneTab) {
  const TempFolder folder;
  folder.write("image.glsl", empty_image);
  folder.write("Image.frag", empty_image);
  EXPECT_EQ(load_error(folder, folder.path(), ExitStatus::file),
            "image.glsl: error: Image.frag is the tab Image already");
}

TEST(LoadFolder, RefusesAnOutputBesideTheHosts) {
  const TempFolder folder;
  folder.write("common.glsl", "int a;\n");
  folder.write("image.glsl", "float b;\nout vec4 other;\n" + std::string(empty_image));
  const std::string text = load_error(folder, folder.path(), ExitStatus::shader);
  EXPECT_TRUE(text.starts_with("image.glsl:2: error: an output of the shader's own")) << text;
}

}  // namespace
}  // namespace shadertwin

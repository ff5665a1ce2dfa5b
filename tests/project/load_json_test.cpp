#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/project/write_json.h"
#include "host/text/load.h"
#include "tests/project/temp_folder.h"

namespace shadertwin {
namespace {

using nlohmann::json;

json input(const json& id, int channel, const std::string& type, const std::string& source,
           json sampler = {}) {
  return {
      {"id", id}, {"channel", channel}, {"ctype", type}, {"src", source}, {"sampler", std::move(sampler)}};
}

json pass(const std::string& type, const json& id, json inputs = json::array(),
          const std::string& code = empty_image) {
  json outputs = json::array();
  if (!id.is_null()) outputs.push_back({{"id", id}, {"channel", 0}});
  return {{"type", type}, {"outputs", outputs}, {"inputs", std::move(inputs)}, {"code", code}, {"name", ""}};
}

json api(json passes) {
  return {{"Shader", {{"ver", "0.1"}, {"info", {{"name", "Toy"}}}, {"renderpass", std::move(passes)}}}};
}

// The same document as the site and its editor write it: string ids, `type` and `filepath`, in an array.
json as_site(json document) {
  const std::map<int, std::string> names = {{37, "4dfGRr"}, {257, "4dXGR8"}, {258, "XsXGR8"}, {41, "4dX3Rr"}};
  const auto rename = [&](json& ids) {
    for (json& item : ids)
      if (item["id"].is_number()) item["id"] = names.at(item["id"]);
  };
  json shader = document["Shader"];
  for (json& each : shader["renderpass"]) {
    rename(each["outputs"]);
    rename(each["inputs"]);
    for (json& item : each["inputs"]) {
      item["type"] = item["ctype"];
      item["filepath"] = item["src"];
      item.erase("ctype");
      item.erase("src");
    }
  }
  return json::array({shader});
}

class LoadJson : public testing::Test {
 protected:
  Project load(const json& document, const LoadOptions& options = {}) const {
    return load_project(folder_.write("toy.json", document.dump()), options);
  }
  std::string error(const json& document, ExitStatus status = ExitStatus::file) const {
    return error_of(document.dump(), status);
  }
  std::string error_of(const std::string& text, ExitStatus status = ExitStatus::file) const {
    return load_error(folder_, folder_.write("toy.json", text), status);
  }

  TempFolder folder_;
};

TEST_F(LoadJson, TakesBothShapesAndTheExport) {
  const json document =
      api({pass("image", 37, {input(258, 2, "buffer", "")}), pass("buffer", 258), pass("buffer", 257)});
  const json site = as_site(document);
  for (const json& shape : {document, site, json{{"userName", "x"}, {"shaders", site}}, site[0]}) {
    const Project project = load(shape);
    EXPECT_EQ(project.dialect, Dialect::shadertoy);
    EXPECT_EQ(project.title, "Toy");
    ASSERT_EQ(project.passes.size(), 3U);
    EXPECT_EQ(project.passes[0].name, "Buffer B");
    EXPECT_EQ(project.passes[1].name, "Buffer A");
    EXPECT_EQ(project.passes[2].name, "Image");
    EXPECT_EQ(project.passes[2].inputs[2].kind, InputKind::pass);
    EXPECT_EQ(project.passes[2].inputs[2].pass, 0);
    EXPECT_TRUE(project.warnings.empty());
  }
}

TEST_F(LoadJson, DrawsSoundThenBuffersAsTheyStandThenCubemapThenImage) {
  const Project project = load(api(
      {pass("image", 37),
       pass("cubemap", 41, json::array(), "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {}"),
       pass("buffer", 259),
       pass("sound", nullptr, json::array(), "vec2 mainSound(int s, float t) { return vec2(t); }"),
       pass("buffer", 257)}));
  std::string names;
  for (const Pass& each : project.passes) names += each.name + ",";
  EXPECT_EQ(names, "Sound,Buffer C,Buffer A,Cubemap A,Image,");
}

TEST_F(LoadJson, PutsEveryCommonInFrontOfEveryPass) {
  const Project project =
      load(api({pass("image", 37), pass("common", nullptr, json::array(), "int c1;\r\nint c2;"),
                pass("common", nullptr, json::array(), "int d1;\n"), pass("buffer", 257)}));
  for (const Pass& each : project.passes) {
    EXPECT_TRUE(each.source.body.starts_with("int c1;\nint c2;\nint d1;\nvoid mainImage"))
        << each.source.body;
    EXPECT_EQ(each.code, empty_image);
    EXPECT_TRUE(project.files[each.source.lines[1].file].ends_with("toy.json:Common"));
    EXPECT_EQ(each.source.lines[1].line, 2);
    EXPECT_TRUE(project.files[each.source.lines[2].file].ends_with("toy.json:Common 2"));
    EXPECT_TRUE(project.files[each.source.lines[3].file].ends_with("toy.json:" + each.name));
    EXPECT_EQ(each.source.lines[3].line, 1);
  }
}

TEST_F(LoadJson, ReadsEverySamplerSetting) {
  folder_.write("t.png", "");
  const Project project = load(api(
      {pass("image", 37,
            {input(1, 0, "texture", "/media/a/t.png",
                   {{"filter", "mipmap"}, {"wrap", "repeat"}, {"vflip", "false"}}),
             input(1, 3, "texture", "t.png", {{"filter", "nearest"}, {"wrap", "clamp"}, {"vflip", true}}),
             input(1, 1, "texture", "t.png"),
             input(33, 2, "keyboard", "/presets/tex00.jpg", {{"filter", "linear"}, {"wrap", "clamp"}})})}));
  const auto& inputs = project.passes[0].inputs;
  EXPECT_EQ(inputs[0].sampler.min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(inputs[0].sampler.mag, MagFilter::linear);
  EXPECT_EQ(inputs[0].sampler.wrap, Wrap::repeat);
  EXPECT_FALSE(inputs[0].sampler.vflip);
  EXPECT_EQ(inputs[3].sampler.min, MinFilter::nearest);
  EXPECT_EQ(inputs[3].sampler.mag, MagFilter::nearest);
  EXPECT_EQ(inputs[3].sampler.wrap, Wrap::clamp);
  EXPECT_TRUE(inputs[3].sampler.vflip);
  EXPECT_TRUE(inputs[1].sampler.vflip);
  EXPECT_EQ(inputs[2].kind, InputKind::keyboard);
  EXPECT_EQ(inputs[2].sampler.mag, MagFilter::nearest);
}

TEST_F(LoadJson, FindsMediaInTheMediaFolder) {
  folder_.write("m/media/a/deep.jpg", "");
  folder_.write("m/flat.jpg", "");
  for (const char* face : {"", "_1", "_2", "_3", "_4", "_5"})
    folder_.write(std::string("m/sky") + face + ".jpg", "");
  folder_.write("m/v.bin", "");
  const json document = api(
      {pass("image", 37,
            {input(1, 0, "texture", "/media/a/deep.jpg"), input("Xdf3zn", 1, "texture", "/media/a/flat.jpg"),
             input(3, 2, "cubemap", "/media/a/sky.jpg"), input(4, 3, "volume", "/media/a/v.bin")})});
  const Project project = load(document, {.media = folder_.path() / "m"});
  const auto& inputs = project.passes[0].inputs;
  ASSERT_EQ(inputs[0].files.size(), 1U);
  EXPECT_EQ(inputs[0].files[0].filename(), "deep.jpg");
  EXPECT_FALSE(inputs[0].red_only);
  EXPECT_TRUE(inputs[1].red_only);
  ASSERT_EQ(inputs[2].files.size(), 6U);
  EXPECT_EQ(inputs[2].files[5].filename(), "sky_5.jpg");
  EXPECT_EQ(inputs[3].kind, InputKind::volume);
  EXPECT_TRUE(project.warnings.empty());
}

TEST_F(LoadJson, KnowsTexturesOfOneChannelByTheirFileWhenTheApiNumbersThem) {
  for (const char* file : {"85a6d68622b36995ccb98a89bbb119edf167c914660e4450d313de049320005c.png",
                           "0a40562379b63dfb89227e6d172f39fdce9022cba76623f1054a2c83d6c0ba5d.png",
                           "0c7bf5fe9462d5bffbd11126e82908e39be3ce56220d900f633d58fb432e56f5.png",
                           "ad56fba948dfba9ae698198c109e71f118a54d209c0ea50d77ea546abad89c57.png",
                           "f735bee5b64ef98879dc618b016ecf7939a5756040c2cde21ccb15e69a6e1cfb.png"}) {
    folder_.write(std::string("m/media/a/") + file, "");
    const Project project =
        load(api({pass("image", 37, {input(30, 0, "texture", std::string("/media/a/") + file)})}),
             {.media = folder_.path() / "m"});
    EXPECT_EQ(project.passes[0].inputs[0].red_only, file[0] != 'f') << file;
  }
}

TEST_F(LoadJson, FindsTheFacesOfACubemapByTheExtensionsNamesToo) {
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
    folder_.write(std::string("m/sky_") + face + ".png", "");
  const Project project = load(api({pass("image", 37, {input(3, 2, "cubemap", "/media/a/sky_px.png")})}),
                               {.media = folder_.path() / "m"});
  ASSERT_EQ(project.passes[0].inputs[2].files.size(), 6U);
  EXPECT_EQ(project.passes[0].inputs[2].files[3].filename(), "sky_ny.png");
  folder_.write("m/half_px.png", "");
  const Project half = load(api({pass("image", 37, {input(3, 2, "cubemap", "/media/a/half_px.png")})}),
                            {.media = folder_.path() / "m"});
  ASSERT_EQ(half.warnings.size(), 1U);
  EXPECT_NE(half.warnings[0].find("\"/media/a/half_px_1.png\" is not in "), std::string::npos);
}

TEST_F(LoadJson, WarnsOnceOfWhatIsMissing) {
  const Project project = load(api({pass("image", 37, {input(1, 0, "texture", "/media/a/no.jpg")}),
                                    pass("buffer", 257, {input(1, 0, "texture", "/media/a/no.jpg")})}));
  EXPECT_EQ(project.passes[1].inputs[0].kind, InputKind::none);
  ASSERT_EQ(project.warnings.size(), 1U);
  EXPECT_NE(project.warnings[0].find("toy.json: warning: \"/media/a/no.jpg\" is not in "), std::string::npos);
}

TEST_F(LoadJson, OpensNothingOutsideOfTheMediaFolder) {
  folder_.write("secret.png", "");
  folder_.write("m/ok.png", "");
  std::filesystem::create_symlink(folder_.path() / "secret.png", folder_.path() / "m/link.png");
  std::filesystem::create_directory_symlink(folder_.path(), folder_.path() / "m/up");
  for (const std::string path : {"../secret.png", "/../secret.png", "a/../../secret.png", "..\\secret.png",
                                 "link.png", "up/secret.png", "https://x.org/secret.png",
                                 "file:///etc/passwd", "C:\\secret.png", "/etc/passwd", "", "/", "."}) {
    const Project project =
        load(api({pass("image", 37, {input(1, 0, "texture", path)})}), {.media = folder_.path() / "m"});
    EXPECT_EQ(project.passes[0].inputs[0].kind, InputKind::none) << path;
    EXPECT_EQ(project.warnings.size(), 1U) << path;
  }
}

TEST_F(LoadJson, CodeOpensNoFile) {
  folder_.write("lib.glsl", "int secret;");
  const std::string code =
      "#if 0\n#include \"lib.glsl\"\n#iChannel0 \"lib.glsl\"\n#endif\n" + std::string(empty_image);
  const Project project = load(api({pass("image", 37, json::array(), code)}));
  EXPECT_EQ(project.passes[0].source.body.find("secret"), std::string::npos);
  EXPECT_EQ(project.passes[0].inputs[0].kind, InputKind::none);
}

TEST_F(LoadJson, FollowsBuffersInCirclesAndByTheirThumbnail) {
  const Project project =
      load(api({pass("image", 37, {input("", 0, "buffer", "/media/previz/buffer01.png")}),
                pass("buffer", 257, {input(258, 0, "buffer", ""), input(257, 1, "buffer", "")}),
                pass("buffer", 258, {input(257, 0, "buffer", "")})}));
  EXPECT_EQ(project.passes[0].inputs[0].pass, 1);
  EXPECT_EQ(project.passes[0].inputs[1].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[0].pass, 0);
  EXPECT_EQ(project.passes[2].inputs[0].pass, 1);
}

TEST_F(LoadJson, BindsTheCubemapPass) {
  const Project project =
      load(api({pass("image", 37, {input(41, 1, "cubemap", "/media/previz/cubemap00.png")}),
                pass("cubemap", 41, json::array(),
                     "void mainCubemap(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {}")}));
  EXPECT_EQ(project.passes[1].inputs[1].pass, 0);
  EXPECT_NE(project.passes[1].source.head.find("uniform samplerCube iChannel1;"), std::string::npos);
  EXPECT_NE(project.passes[0].source.head.find("uniform int shadertwin_face;"), std::string::npos);
}

TEST_F(LoadJson, TakesBothFormsOfMainSound) {
  const auto head = [&](const std::string& code) {
    return load(api({pass("image", 37), pass("sound", nullptr, json::array(), code)})).passes[0].source.head;
  };
  EXPECT_NE(head("vec2 mainSound(in int samp, float time) { return vec2(0); }")
                .find("vec2 mainSound(in int, in float);"),
            std::string::npos);
  for (const char* code : {"vec2 mainSound(float time) { return vec2(0); }",
                           "#define play mainSound\nvec2 play(float time) { return vec2(0); }",
                           "#define SOUND(t) vec2 mainSound(float t)\nSOUND(time) { return vec2(0); }"})
    EXPECT_NE(head(code).find("vec2 mainSound(in float);"), std::string::npos) << code;
  EXPECT_NE(head("#define play mainSound\nvec2 play(int samp, float time) { return vec2(0); }")
                .find("vec2 mainSound(in int, in float);"),
            std::string::npos);
}

TEST_F(LoadJson, ReadsChannelStructsAsUniforms) {
  const std::string code =
      "vec4 f() { return texture(iCh1.sampler, iCh2.size.xy) * iCh0.time * float(iCh3 . loaded); }\n";
  const Pass loaded =
      load(api({pass("image", 37, {input(33, 3, "keyboard", "")}, code + empty_image)})).passes[0];
  EXPECT_TRUE(
      loaded.source.body.starts_with("vec4 f() { return texture(iChannel1, iChannelResolution[2].xy) * "
                                     "iChannelTime[0] * float(shadertwin_loaded_3); }\n"))
      << loaded.source.body;
  EXPECT_NE(loaded.source.head.find("const int shadertwin_loaded_3 = 1;\n"), std::string::npos);
}

TEST_F(LoadJson, GivesAnEmptyChannelTheSamplerOfWhatIsMissing) {
  const Project project = load(api(
      {pass("image", 37,
            {input(1, 0, "cubemap", "/media/a/no.jpg"), input(2, 1, "volume", "/no.bin"),
             input(41, 2, "cubemap", "/media/previz/cubemap00.png"), input(3, 3, "texture", "/no.jpg")})}));
  const std::string& head = project.passes[0].source.head;
  EXPECT_NE(head.find("uniform samplerCube iChannel0;"), std::string::npos);
  EXPECT_NE(head.find("uniform sampler3D iChannel1;"), std::string::npos);
  EXPECT_NE(head.find("uniform samplerCube iChannel2;"), std::string::npos);
  EXPECT_NE(head.find("uniform sampler2D iChannel3;"), std::string::npos);
  EXPECT_EQ(project.passes[0].inputs[2].kind, InputKind::undrawn);
  EXPECT_EQ(project.passes[0].inputs[2].undrawn, PassKind::cubemap);
  for (const int i : {0, 1, 3}) EXPECT_EQ(project.passes[0].inputs[i].kind, InputKind::none);
}

TEST_F(LoadJson, DrawsMainVrWhenAsked) {
  const std::string code =
      "void mainVR(out vec4 c, in vec2 p, in vec3 o, in vec3 d) {}\n" + std::string(empty_image);
  const json document = api({pass("image", 37, json::array(), code)});
  EXPECT_TRUE(load(document).passes[0].has_vr);
  EXPECT_EQ(load(document).passes[0].source.head.find("mainVR("), std::string::npos);
  EXPECT_NE(load(document, {.settings = {.vr = true}}).passes[0].source.head.find("mainVR("),
            std::string::npos);
  EXPECT_FALSE(load(api({pass("image", 37)})).passes[0].has_vr);
}

TEST_F(LoadJson, ReportsBrokenDocuments) {
  EXPECT_EQ(error_of("{\"Shader\": {\n  \"ver\""),
            "toy.json:2: error: this is not JSON: the text ends too early");
  EXPECT_EQ(error_of(""), "toy.json:1: error: this is not JSON: the text ends too early");
  EXPECT_EQ(error_of("5"), "toy.json: error: the document is no shader");
  EXPECT_EQ(error_of("[]"), "toy.json: error: there is no shader");
  EXPECT_EQ(error_of("{}"),
            "toy.json: error: there is no shader: neither \"Shader\" nor \"shaders\" nor \"renderpass\"");
  EXPECT_EQ(error_of("{\"Error\": \"Shader not found\"}"),
            "toy.json: error: this is Shadertoy's answer \"Shader not found\", no shader");
  EXPECT_EQ(error({{"Shader", 5}}), "toy.json: error: Shader is not an object");
  EXPECT_EQ(error({{"Shader", json::object()}}), "toy.json: error: there is no \"renderpass\"");
  EXPECT_EQ(error(api(5)), "toy.json: error: renderpass is not an array");
  EXPECT_EQ(error(api({5})), "toy.json: error: a pass is not an object");
  EXPECT_EQ(error(api({{{"type", "image"}}})), "toy.json: error: there is no \"code\"");
  EXPECT_EQ(error(api({{{"type", "image"}, {"code", 7}}})), "toy.json: error: a pass's code is not a string");
  EXPECT_EQ(error(api({pass("geometry", 1)})), "toy.json: error: a pass has the unknown type \"geometry\"");
  EXPECT_EQ(error(api({pass("image", 37, {5})})), "toy.json: error: an input is not an object");
  EXPECT_EQ(error(api({pass("image", 37, {input(1, 7, "texture", "")})})),
            "toy.json: error: an input of Image has no channel from 0 to 3");
  EXPECT_EQ(error(api({pass("buffer", 257)}), ExitStatus::shader),
            "toy.json: error: there are 0 image passes, not one");
  EXPECT_EQ(error(api({pass("image", 37, json::array(), "float f;")}), ExitStatus::shader),
            "toy.json:Image:1: error: there is no mainImage(out vec4, in vec2) and no main()");
}

TEST_F(LoadJson, RefusesAMillionInputsAndPasses) {
  EXPECT_EQ(error(api({pass("image", 37, json(1000000, json::object()))})),
            "toy.json: error: Image has 1000000 inputs");
  EXPECT_EQ(error(api(json(100000, pass("buffer", 257)))), "toy.json: error: there are 100000 passes");
}

TEST_F(LoadJson, SurvivesWrongTypesEverywhere) {
  const json document =
      api({pass("image", 37, {input(1, 0, "texture", "t.png", {{"filter", "linear"}, {"vflip", "true"}})}),
           pass("buffer", 257, {input(257, 0, "buffer", "")})});
  const json flat = document.flatten();
  for (const auto& [path, value] : flat.items())
    for (const json& wrong :
         {json(), json(-1), json(1e300), json("x"), json::array({1}), json::object(), json(true)}) {
      json broken = document;
      broken[json::json_pointer(path)] = wrong;
      try {
        load(broken);
      } catch (const Error& problem) {
        EXPECT_EQ(std::string(problem.what()).find('\n'), std::string::npos);
      }
    }
}

TEST_F(LoadJson, RoundTripKeepsWhatIsNotUnderstood) {
  json document = api({pass("image", 37)});
  document["Shader"]["info"]["strange"] = {1, {{"deep", "Tëst"}}};
  document["Shader"]["renderpass"][0]["future"] = nullptr;
  EXPECT_EQ(json::parse(write_json(load(document))), document);
}

TEST_F(LoadJson, CommonTakesAnotherTextAndAllElseStays) {
  json document = api({pass("image", 37)});
  document["Shader"]["info"]["strange"] = {1, {{"deep", "Tëst"}}};
  for (const json& shape : {document, as_site(document), json{{"shaders", as_site(document)}, {"more", 1}}}) {
    json changed = json::parse(with_common(shape.dump(), "#define K 2\n"));
    EXPECT_EQ(load(changed).common, "#define K 2\n");
    json twice = json::parse(with_common(changed.dump(), "#define J 1\n"));
    EXPECT_EQ(load(twice).common, "#define J 1\n#define K 2\n");
    json& passes = changed.is_array()           ? changed[0]["renderpass"]
                   : changed.contains("Shader") ? changed["Shader"]["renderpass"]
                                                : changed["shaders"][0]["renderpass"];
    passes.erase(1);
    EXPECT_EQ(changed, shape);
  }
}

TEST(WriteJson, NamesACubemapByItsFirstFaceAndFindsItAgain) {
  const TempFolder folder;
  for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"})
    folder.write(std::string("sky_") + face + ".png", "");
  const std::string text = "#iChannel1 \"sky_{}.png\"\n#iChannel1::Type \"CubeMap\"\n";
  folder.write("out/toy.json", write_json(load_project(folder.write("a.glsl", text + empty_image))));
  const Project project = load_project(folder.path() / "out/toy.json", {.media = folder.path()});
  ASSERT_EQ(project.passes[0].inputs[1].files.size(), 6U);
  EXPECT_EQ(project.passes[0].inputs[1].files[4].filename(), "sky_posz.png");
}

TEST(WriteJson, GivesAFolderBackAsItWas) {
  const TempFolder folder;
  folder.write("image.glsl",
               "#iChannel1 \"buffer_b.glsl\"\n#iChannel0 \"t.png\"\n#iChannel0::WrapMode \"Clamp\"\n" +
                   std::string(empty_image));
  folder.write("buffer_b.glsl", "#iChannel3 \"self\"\n" + std::string(empty_image));
  folder.write("common.glsl", "#iUniform vec2 k = vec2(0.5, 2.0)\nfloat f;\n");
  folder.write("t.png", "");
  folder.write("out/toy.json", write_json(load_project(folder.path())));
  const Project project = load_project(folder.path() / "out/toy.json", {.media = folder.path()});
  ASSERT_EQ(project.passes.size(), 2U);
  EXPECT_EQ(project.passes[0].name, "Buffer B");
  EXPECT_EQ(project.passes[0].inputs[3].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[1].pass, 0);
  EXPECT_EQ(project.passes[1].inputs[0].files.at(0).filename(), "t.png");
  EXPECT_EQ(project.passes[1].inputs[0].sampler.wrap, Wrap::clamp);
  EXPECT_EQ(project.common, "const vec2 k = vec2(0.5, 2);\n\nfloat f;\n");
}

TEST(WriteJson, SaysWhatTheSiteDoesNotHave) {
  const TempFolder folder;
  const auto error = [&](const std::string& text) -> std::string {
    try {
      write_json(load_project(folder.write("a.glsl", text)));
    } catch (const Error& problem) {
      EXPECT_EQ(problem.status(), ExitStatus::shader);
      return problem.what();
    }
    return "none";
  };
  EXPECT_EQ(error("#iChannel0 \"self\"\n" + std::string(empty_image)),
            "a: error: shadertoy.com can't read the image in iChannel0");
  EXPECT_EQ(error("void main() {}"), "a: error: shadertoy.com needs mainImage(), and this has main()");
  folder.write("b.glsl", empty_image);
  EXPECT_EQ(error("#iChannel5 \"b.glsl\"\n" + std::string(empty_image)),
            "a: error: shadertoy.com has no iChannel5");
  EXPECT_EQ(error("#iChannel1 \"b.glsl\"\n" + std::string(empty_image)), "none");
}

}  // namespace
}  // namespace shadertwin

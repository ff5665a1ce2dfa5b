// Messages of the driver name the user's own files and lines.
#include "host/base/error.h"
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using ShaderErrors = OnEveryDevice;

TEST_P(ShaderErrors, NameTheLineInTheFile) {
  const auto shader =
      folder.write("bad.glsl", "\n\nvoid mainImage(out vec4 c, in vec2 p) {\n  c = nothing;\n}\n");
  try {
    play(load_project(shader));
    FAIL() << "the shader compiled";
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), ExitStatus::shader);
    EXPECT_NE(std::string(e.what()).find("bad.glsl:4: error: "), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("nothing"), std::string::npos) << e.what();
  }
}

TEST_P(ShaderErrors, NameTheLineInAnInclude) {
  folder.write("lib/deep.glsl", "float deep() {\n  return undefined_thing;\n}\n");
  folder.write("lib/mid.glsl", "float mid() { return 1.; }\n#include \"deep.glsl\"\n");
  const auto shader = folder.write(
      "main.glsl", "#include \"lib/mid.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(mid()); }\n");
  try {
    play(load_project(shader));
    FAIL() << "the shader compiled";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("deep.glsl:2: error: "), std::string::npos) << e.what();
  }
}

TEST_P(ShaderErrors, NameTheLineInCommonAndInATab) {
  folder.write("tabs/common.glsl", std::string(50, '\n') + "float broken( { }\n");
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  try {
    play(load_project(folder / "tabs"));
    FAIL() << "the shader compiled";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("common.glsl:51: error: "), std::string::npos) << e.what();
  }
  folder.write("tabs/common.glsl", std::string(50, '\n'));
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) {\n\n  c = vec4(1) }\n");
  try {
    play(load_project(folder / "tabs"));
    FAIL() << "the shader compiled";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("image.glsl:3: error: "), std::string::npos) << e.what();
  }
}

// Whoever gives a text that the driver refuses gets the shader's own, and one warning for all passes.
TEST_P(ShaderErrors, ARewrittenTextThatIsRefusedIsReplacedWithOneWarning) {
  folder.write("b.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(2); }");
  const auto shader =
      folder.write("a.glsl",
                   "#iChannel0 \"b.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, "
                   "ivec2(p), 0); }\n");
  const Project project = load_project(shader);
  gl::PlayerOptions options{GetParam().dispatch};
  options.sources = [](const Project&, const Pass& pass, const ShowsFault&) {
    PassSource broken = pass.source;
    broken.body += "\nfloat broken = ;\n";
    return std::vector{broken, pass.source};
  };
  const auto player = gl::make_player(gl::open_context(GetParam().name), project, options);
  ASSERT_EQ(player->warnings().size(), 1U);
  EXPECT_EQ(player->warnings()[0].rfind("b: warning: runs as written", 0), 0U) << player->warnings()[0];
  EXPECT_NE(player->warnings()[0].find("the driver refuses the rewritten text: "), std::string::npos);
  EXPECT_EQ(player->warnings()[0].find('\n'), std::string::npos);
  FixedClock clock(small(), host_rules(project));
  player->render(clock.next());
  EXPECT_EQ(pixel(player->read(1)), glm::vec4(2));
  options.sources = [](const Project&, const Pass& pass, const ShowsFault&) {
    return std::vector{pass.source};
  };
  EXPECT_EQ(gl::make_player(gl::open_context(GetParam().name), project, options)->warnings().size(), 1U)
      << "a text that could not be rewritten";
}

SHADERTWIN_ON_EVERY_DEVICE(ShaderErrors);

}  // namespace
}  // namespace shadertwin

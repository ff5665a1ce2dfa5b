// What only the extension has: its keyboard, ten channels, uniforms of every type.
#include "host/player/keyboard.h"
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using Dialects = OnEveryDevice;

TEST_P(Dialects, KeyFunctionsFollowAPressAReleaseAndATap) {
  const Project project = load_project(folder.write("keys.glsl", R"(
#iKeyboard
const int Key_Space = 32;  // the extension has no name for it
void mainImage(out vec4 c, in vec2 p) {
  int key = p.x < 1. ? Key_Q : p.x < 2. ? Key_SingleQuote : Key_Space;
  c = vec4(isKeyDown(key), isKeyPressed(key), isKeyToggled(key), isKeyReleased(key));
}
)"));
  const auto player = play(project);
  KeyboardState keyboard(host_rules(Dialect::vscode));
  const auto next = [&] {
    Frame frame;
    frame.width = 3;
    frame.height = 1;
    frame.keyboard = keyboard.rows();
    player->render(frame);
    keyboard.end_frame();
    return player->read(0);
  };
  keyboard.press('Q');
  keyboard.press(32);
  Image image = next();
  EXPECT_EQ(pixel(image, 0), glm::vec4(1, 1, 1, 0));
  EXPECT_EQ(pixel(image, 1), glm::vec4(0));
  EXPECT_EQ(pixel(image, 2), glm::vec4(1, 1, 1, 0));
  keyboard.release('Q');
  keyboard.press(222);
  keyboard.release(222);
  image = next();
  EXPECT_EQ(pixel(image, 0), glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(pixel(image, 1), glm::vec4(0, 1, 1, 1)) << "a tap between two frames";
  EXPECT_EQ(pixel(image, 2), glm::vec4(1, 0, 1, 0));
  image = next();
  EXPECT_EQ(pixel(image, 0), glm::vec4(0, 0, 1, 0));
}

TEST_P(Dialects, TenChannelsReadTenPasses) {
  std::string text;
  std::string sum;
  for (int i = 0; i < 10; ++i) {
    const std::string n = std::to_string(i);
    folder.write("p" + n + ".glsl",
                 "void mainImage(out vec4 c, in vec2 p) { c = vec4(" + std::to_string(1 << i) + "); }");
    text += "#iChannel" + n + " \"p" + n + ".glsl\"\n";
    sum += " + texelFetch(iChannel" + n + ", ivec2(0), 0).x * iChannelResolution[" + n + "].x";
  }
  const auto shader =
      folder.write("ten.glsl", text + "void mainImage(out vec4 c, in vec2 p) { c = vec4(0." + sum + "); }");
  EXPECT_EQ(pixel(frames(load_project(shader), 1, small(2, 1))[0]), glm::vec4(2 * 1023));
}

TEST_P(Dialects, CustomUniformsOfEveryTypeReachTheShader) {
  const auto shader = folder.write("types.glsl", R"(
#iUniform float a = 1.5 in { 0.0, 2.0 } step 0.5
#iUniform vec2 b = vec2(2.0, 3.0) in [0.0, 4.0]
#iUniform vec3 c3 = vec3(4.0, 5.0, 6.0)
#iUniform vec4 d = vec4(7.0, 8.0, 9.0, 10.0) in { vec4(0.0, 0.0, 0.0, 0.0), vec4(20.0, 20.0, 20.0, 20.0) }
#iUniform int e = 11 in { 0, 20 }
#iUniform ivec2 f = ivec2(12, 13)
#iUniform ivec3 g = ivec3(14, 15, 16)
#iUniform ivec4 h = ivec4(17, 18, 19, 20)
#iUniform color3 i = color3(0.25, 0.5, 0.75)
#iUniform float k in { 21.0, 30.0 }
void mainImage(out vec4 c, in vec2 p) {
  int x = int(p.x);
  c = x == 0 ? vec4(a, b, k) : x == 1 ? vec4(c3, e) : x == 2 ? d : x == 3 ? vec4(f, 0, 0) : x == 4 ? vec4(g, 0)
    : x == 5 ? vec4(h) : vec4(i, 1);
}
)");
  const Image image = frames(load_project(shader), 1, small(7, 1))[0];
  const std::vector<glm::vec4> expected = {{1.5F, 2, 3, 21},       {4, 5, 6, 11},   {7, 8, 9, 10},
                                           {12, 13, 0, 0},         {14, 15, 16, 0}, {17, 18, 19, 20},
                                           {0.25F, 0.5F, 0.75F, 1}};
  for (int x = 0; x < 7; ++x) EXPECT_EQ(pixel(image, x), expected[static_cast<std::size_t>(x)]) << x;
}

SHADERTWIN_ON_EVERY_DEVICE(Dialects);

}  // namespace
}  // namespace shadertwin

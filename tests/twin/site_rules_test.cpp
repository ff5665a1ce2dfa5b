// What shadertoy.com's passes, targets and channels do, on every player and precision: the same small shaders
// on OpenGL, as fragments and as compute, and on the twin, in float and in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "host/base/error.h"
#include "host/gl/gl_player.h"
#include "host/player/fixed_clock.h"
#include "reference/twin/twin_player.h"
#include "tests/scratch_folder.h"

namespace shadertwin {
namespace {

class SiteRules : public testing::TestWithParam<std::string> {
 protected:
  static std::unique_ptr<Player> play(const Project& project) {
    const std::string& name = GetParam();
    if (name.starts_with("cpu")) {
      twin::TwinOptions options;
      options.double_precision = name == "cpu/double";
      return twin::TwinPlayer::create(project, options);
    }
    gl::PlayerOptions options;
    options.dispatch = name.ends_with("compute") ? gl::Dispatch::compute : gl::Dispatch::fragment;
    return gl::GlPlayer::create(gl::open_context(name.substr(0, name.find('/'))), project, options);
  }

  static Frame frame(int index, int width = 4, int height = 3) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.index = index;
    return frame;
  }

  // The picture after each of `count` frames.
  static std::vector<Image> pictures(const Project& project, int count, int width = 4, int height = 3) {
    const auto player = play(project);
    std::vector<Image> result;
    for (int i = 0; i < count; ++i) {
      player->render(frame(i, width, height));
      result.push_back(player->read(static_cast<int>(project.passes.size()) - 1));
    }
    return result;
  }

  static glm::vec4 pixel(const Image& image, int x = 0, int y = 0) {
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
  }

  // A shader as the API gives it. `passes`: the texts of the renderpass objects.
  std::filesystem::path json(const std::string& name, const std::string& passes) const {
    return folder.write(name,
                        R"({"Shader": {"ver": "0.1", "info": {"id": "x"}, "renderpass": [)" + passes + "]}}");
  }
  static std::string pass(const std::string& type, int id, const std::string& inputs,
                          const std::string& code) {
    return R"({"type": ")" + type + R"(", "name": "", "outputs": [{"id": )" + std::to_string(id) +
           R"(, "channel": 0}], "inputs": [)" + inputs + R"(], "code": ")" + code + "\"}";
  }
  static std::string input(int id, const std::string& type, int channel, const std::string& source = "") {
    return R"({"id": )" + std::to_string(id) + R"(, "ctype": ")" + type + R"(", "channel": )" +
           std::to_string(channel) + R"(, "src": ")" + source +
           R"(", "sampler": {"filter": "nearest", "wrap": "clamp", "vflip": "true"}})";
  }

  ScratchFolder folder;
};

// Buffers draw in the order of the array: who stands first reads the other's last frame.
TEST_P(SiteRules, BuffersDrawInTheOrderOfTheJson) {
  const std::string count =
      "void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame) + 1., texelFetch(iChannel0, ivec2(p), "
      "0).x, 0, "
      "1); }";
  const std::string a = pass("buffer", 257, input(258, "buffer", 0), count);
  const std::string b = pass("buffer", 258, input(257, "buffer", 0), count);
  const std::string image =
      pass("image", 37, input(257, "buffer", 0) + "," + input(258, "buffer", 1),
           "void mainImage(out vec4 c, in vec2 p) { c = vec4(texelFetch(iChannel0, ivec2(p), 0).xy, "
           "texelFetch(iChannel1, ivec2(p), 0).xy); c.a = 1.; c.z = texelFetch(iChannel1, ivec2(p), 0).y; }");
  const auto straight = pictures(load_project(json("ab.json", a + "," + b + "," + image)), 3);
  const auto permuted = pictures(load_project(json("ba.json", image + "," + b + "," + a)), 3);
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(pixel(straight[at]), glm::vec4(i + 1, i, i + 1, 1)) << "frame " << i;
    EXPECT_EQ(pixel(permuted[at]), glm::vec4(i + 1, i + 1, i, 1)) << "frame " << i;
  }
}

TEST_P(SiteRules, DiscardKeepsTheBufferOfTwoFramesAgoAndThePicture) {
  folder.write("tabs/buffer_a.glsl",
               "void mainImage(out vec4 c, in vec2 p) { if (iFrame % 2 == 1) discard; c = vec4(float(iFrame) "
               "+ 1.); }");
  folder.write("tabs/image.glsl",
               "#iChannel0 \"buffer_a.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  if (iFrame == 2 && p.x > 1.) discard;\n"
               "  c = texelFetch(iChannel0, ivec2(p), 0);\n}\n");
  const auto images = pictures(load_project(folder / "tabs"), 4);
  const float buffer[4] = {1, 0, 3, 0};  // frames 1 and 3 leave the other picture, that nothing drew yet
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(pixel(images[i]).x, buffer[i]) << "frame " << i;
  EXPECT_EQ(pixel(images[1], 1).x, 0);
  EXPECT_EQ(pixel(images[2], 1).x, 0) << "the picture keeps what it showed";
}

// Both of a buffer's pictures keep their lower left pixels, and the older may be the one that is read next.
TEST_P(SiteRules, ResizingKeepsTheLowerLeftPixelsAndReadsTheFirstPicture) {
  folder.write("tabs/buffer_a.glsl",
               "#iChannel0 \"self\"\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  vec4 last = texelFetch(iChannel0, ivec2(p), 0);\n"
               "  c = last.w == 0. || iFrame < 2 ? vec4(p, float(iFrame) + 1., 1) : last;\n}\n");
  folder.write("tabs/image.glsl",
               "#iChannel0 \"buffer_a.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }");
  const Project project = load_project(folder / "tabs");
  // Frame 0 draws the second picture, frame 1 the first: after one frame the empty one is read, after two the
  // newest.
  for (const int frames : {1, 2}) {
    const auto player = play(project);
    for (int i = 0; i < frames; ++i) player->render(frame(i));
    player->render(frame(2, 6, 5));
    const Image image = player->read(1);
    ASSERT_EQ(image.width, 6);
    ASSERT_EQ(image.height, 5);
    EXPECT_EQ(pixel(image, 3, 2), glm::vec4(3.5F, 2.5F, frames == 1 ? 3 : 2, 1)) << frames;
    EXPECT_EQ(pixel(image, 4, 2), glm::vec4(4.5F, 2.5F, 3, 1)) << frames;
    EXPECT_EQ(pixel(image, 3, 3), glm::vec4(3.5F, 3.5F, 3, 1)) << frames;
    player->render(frame(3, 2, 2));
    EXPECT_EQ(player->read(1).width, 2);
  }
}

// What a buffer discards after a change of size is what the same place held before it.
TEST_P(SiteRules, ResizingKeepsWhatADiscardLeaves) {
  folder.write(
      "tabs/buffer_a.glsl",
      "void mainImage(out vec4 c, in vec2 p) { if (iFrame > 1) discard; c = vec4(p, float(iFrame), 1); }");
  folder.write("tabs/image.glsl",
               "#iChannel0 \"buffer_a.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }");
  const auto player = play(load_project(folder / "tabs"));
  for (int i = 0; i < 2; ++i) player->render(frame(i));
  player->render(frame(2, 6, 5));
  EXPECT_EQ(pixel(player->read(1), 3, 2), glm::vec4(3.5F, 2.5F, 0, 1)) << "the second picture, of frame 0";
  EXPECT_EQ(pixel(player->read(1), 5, 4), glm::vec4(0, 0, 0, 1));
}

TEST_P(SiteRules, EmptyChannelsOfEveryKindAreOpaqueBlack) {
  const std::string lookups =
      "void mainImage(out vec4 c, in vec2 p) { c = vec4(texture(iChannel0, vec3(p, 1)).a, texture(iChannel1, "
      "vec3(p, "
      "1)).a, texture(iChannel2, p).a, 1) + vec4(texture(iChannel0, vec3(1)).rgb + texture(iChannel1, "
      "vec3(0)).rgb + "
      "texture(iChannel2, p).rgb, 0); }";
  const Project project =
      load_project(json("empty.json", pass("image", 37,
                                           input(23, "cubemap", 0, "/media/a/no.jpg") + "," +
                                               input(24, "volume", 1, "/media/a/no.bin"),
                                           lookups)));
  EXPECT_EQ(pixel(pictures(project, 1)[0], 1, 1), glm::vec4(1));
}

TEST_P(SiteRules, FragCoordIsThePixelsCentreAlsoFarOut) {
  folder.write("tabs/image.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = vec4(fract(p) == vec2(.5), p - .5 == floor(p), floor(p));\n}\n");
  const Project project = load_project(folder / "tabs");
  for (const glm::ivec2 size : {glm::ivec2(4096, 2), glm::ivec2(2, 4096)}) {
    const auto player = play(project);
    player->render(frame(0, size.x, size.y));
    const Image image = player->read(0);
    int wrong = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) wrong += glm::vec3(pixel(image, x, y)) != glm::vec3(1, 1, x) ? 1 : 0;
    EXPECT_EQ(wrong, 0) << size.x << 'x' << size.y;
  }
}

// The API's spelling of a shader and the site's: ids as numbers or strings, ctype and src or type and
// filepath.
TEST_P(SiteRules, BothSpellingsOfAJsonDrawTheSamePicture) {
  Image texture(2, 2);
  for (std::size_t i = 0; i < texture.rgba.size(); ++i) texture.rgba[i] = static_cast<float>(i % 7) / 8;
  write_image(texture, folder / "t.png");
  const std::string buffer =
      "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel3, ivec2(p) % 2, 0) + .5 * "
      "texelFetch(iChannel0, "
      "ivec2(p), 0); }";
  const std::string image =
      "void mainImage(out vec4 c, in vec2 p) { c = sqrt(texelFetch(iChannel1, ivec2(p), 0)) + "
      "texelFetch(iChannel2, ivec2(0), 0); }";
  const Project api = load_project(
      json("api.json",
           pass("image", 37, input(258, "buffer", 1) + "," + input(33, "keyboard", 2, "/presets/tex00.jpg"),
                image) +
               "," +
               pass("buffer", 258, input(5, "texture", 3, "/media/a/t.png") + "," + input(258, "buffer", 0),
                    buffer)));
  const auto site_input = [](const std::string& id, const std::string& type, int channel,
                             const std::string& path) {
    return R"({"id": ")" + id + R"(", "type": ")" + type + R"(", "channel": )" + std::to_string(channel) +
           R"(, "filepath": ")" + path +
           R"(", "sampler": {"filter": "nearest", "wrap": "clamp", "vflip": true}, "published": 1})";
  };
  const auto site_pass = [](const std::string& type, const std::string& id, const std::string& inputs,
                            const std::string& code) {
    return R"({"type": ")" + type + R"(", "name": "", "outputs": [{"id": ")" + id +
           R"(", "channel": 0}], "inputs": [)" + inputs + R"(], "code": ")" + code + "\"}";
  };
  const Project site = load_project(folder.write(
      "site.json", R"([{"ver": "0.1", "renderpass": [)" +
                       site_pass("image", "4dfGRr",
                                 site_input("XsXGR8", "buffer", 1, "/media/previz/buffer01.png") + "," +
                                     site_input("4dXGRr", "keyboard", 2, "/presets/tex00.jpg"),
                                 image) +
                       "," +
                       site_pass("buffer", "XsXGR8",
                                 site_input("Xsf3zn", "texture", 3, "/media/a/t.png") + "," +
                                     site_input("XsXGR8", "buffer", 0, "/media/previz/buffer01.png"),
                                 buffer) +
                       "]}]"));
  const auto a = pictures(api, 3);
  const auto b = pictures(site, 3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(a[i].rgba, b[i].rgba) << "frame " << i;
  EXPECT_NE(a[1].rgba, a[2].rgba);
  EXPECT_GT(pixel(a[2], 1, 1).x, 0.0F);
}

// Of one channel: held, pressed in this frame, toggled. The picture changes with every frame.
TEST_P(SiteRules, KeyboardChannelHasOneColourAndShowsAPressForOneFrame) {
  const Project project = load_project(
      json("keys.json",
           pass("image", 37, input(33, "keyboard", 3, "/presets/tex00.jpg"),
                "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel3, ivec2(65, p.y), 0); "
                "c.rgb *= float(textureSize(iChannel3, 0).y - 2); }")));
  const auto player = play(project);
  Schedule schedule;
  schedule.width = 2;
  schedule.height = 3;
  schedule.keys = {{1, 65}};
  FixedClock clock(schedule, project.dialect);
  for (int i = 0; i < 3; ++i) {
    player->render(clock.next());
    const Image image = player->read(0);
    const float rows[3][3] = {{0, 0, 0}, {1, 1, 1}, {1, 0, 1}};
    for (int y = 0; y < 3; ++y)
      EXPECT_EQ(pixel(image, 0, y), glm::vec4(rows[i][y], 0, 0, 1)) << "frame " << i << ", row " << y;
  }
}

// shadertoy.com plays nothing as long as a pass has an error, and says where.
TEST_P(SiteRules, AnErrorInTheSoundKeepsThePicturesFromPlaying) {
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }");
  folder.write("tabs/sound.glsl", "vec2 mainSound(int s, float t) {\n  return vec3(t);\n}\n");
  try {
    play(load_project(folder / "tabs"));
    FAIL() << "it plays";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::shader);
    EXPECT_NE(std::string(error.what()).find("sound.glsl:2: error: "), std::string::npos) << error.what();
  }
}

// The names of entry points may be macros.
TEST_P(SiteRules, MacrosMayNameTheEntryPoints) {
  folder.write("tabs/image.glsl",
               "#define I mainImage\nvoid I(out vec4 c, in vec2 p) { c = vec4(.25, .5, .75, 0); }");
  folder.write("tabs/sound.glsl", "#define S mainSound\nvec2 S(float t) { return vec2(t, .5); }\n");
  const Project project = load_project(folder / "tabs");
  const auto player = play(project);
  player->render(frame(0));
  EXPECT_EQ(pixel(player->read(1)), glm::vec4(.25F, .5F, .75F, 1));
  EXPECT_EQ(pixel(player->sound_block(0, glm::vec4(0)), 441), glm::vec4(.01F, .5F, 0, 1));
}

std::string player_name(const testing::TestParamInfo<std::string>& player) {
  std::string name = player.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(, SiteRules,
                         testing::Values("egl/fragment", "egl/compute", "osmesa/fragment", "cpu",
                                         "cpu/double"),
                         player_name);

}  // namespace
}  // namespace shadertwin

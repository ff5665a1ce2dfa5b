// What shadertoy.com's channels hold, on every player.
#include <cmath>

#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "tests/twin/every_player.h"

namespace shadertwin {
namespace {

using SiteInputs = OnEveryPlayer;

TEST_P(SiteInputs, EmptyChannelsOfEveryKindAreOpaqueBlack) {
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

TEST_P(SiteInputs, AMissingBufferIsAsLargeAsThePictureAlsoAfterAResize) {
  const Project project = load_project(json(
      "gone.json",
      pass("image", 37,
           input(259, "buffer", 0) + "," + input(41, "cubemap", 1, "/media/previz/cubemap00.png"),
           "void mainImage(out vec4 c, in vec2 p) { c = vec4(iChannelResolution[0].xy, "
           "vec2(textureSize(iChannel0, 0))) + texture(iChannel0, p) + texture(iChannel1, vec3(p, 1)); }")));
  const auto player = play(project);
  for (const glm::ivec2 size : {glm::ivec2(4, 3), glm::ivec2(9, 5), glm::ivec2(2, 7)}) {
    player->render(frame(1, size.x, size.y));
    const Image image = player->read(0);
    const float* corner = image.at(0, 0);
    EXPECT_EQ(glm::vec3(corner[0], corner[1], corner[2]), glm::vec3(size, size.x));
  }
}

// Three days at 60 frames a second: past the integers that floats hold.
TEST_P(SiteInputs, FramesAreCountedBeyondTwentyFourBits) {
  const Project project =
      load_project(json("late.json", pass("image", 37, "",
                                          "void mainImage(out vec4 c, in vec2 p) { c.rgb = vec3(iFrame & "
                                          "255, iFrame >> 8 & 255, iFrame >> 16); }")));
  const auto player = play(project);
  for (const int index : {(1 << 24) + 1, 0x7ffffffe}) {
    Frame late = frame(0, 1, 1);
    late.index = index;
    player->render(late);
    const Image image = player->read(0);
    const float* got = image.at(0, 0);
    EXPECT_EQ(glm::vec3(got[0], got[1], got[2]), glm::vec3(index & 255, index >> 8 & 255, index >> 16));
  }
}

// Whoever reads with mipmaps has those of this frame, and each reader its own filter.
TEST_P(SiteInputs, BuffersHaveTheirReadersFiltersAndMipmapsOfThisFrame) {
  const Project project = load_project(json(
      "mips.json",
      pass("buffer", 257, "",
           "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.x < 4. ? 2. : 4.) * float(iFrame + 1); }") +
          "," +
          pass("buffer", 258, input(257, "buffer", 0),
               "void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec2(.499, .5), 0.); }") +
          "," +
          pass("image", 37,
               input(257, "buffer", 0, "", "mipmap") + "," + input(258, "buffer", 1, "", "nearest"),
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(textureLod(iChannel0, vec2(.5), 9.).x, "
               "textureLod(iChannel0, vec2(.5), 0.).x, texelFetch(iChannel1, ivec2(p), 0).x, 1); }")));
  const auto images = pictures(project, 2, 8, 8);
  EXPECT_EQ(pixel(images[0], 3, 3), glm::vec4(3, 3, 2, 1));
  EXPECT_EQ(pixel(images[1], 3, 3), glm::vec4(6, 6, 4, 1));
}

// Bytes over 255, the lower row at v = 0 unless vflip is off, red alone for the site's textures of one
// channel, and nearest both near and far.
TEST_P(SiteInputs, TexturesAreTheirBytesTheRightWayUp) {
  Image image(2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x)
      for (int c = 0; c < 4; ++c)
        image.at(x, y)[c] = c == 3 ? 1.0F : static_cast<float>(128 + 40 * y + 20 * x) / 255.0F;
  write_image(image, folder / "t.png");
  const std::string red = "0c7bf5fe9462d5bffbd11126e82908e39be3ce56220d900f633d58fb432e56f5.png";
  write_image(image, folder / red);
  const Project project = load_project(json(
      "bytes.json",
      pass("image", 37,
           input(5, "texture", 0, "/media/a/t.png") + "," +
               input(5, "texture", 1, "/media/a/t.png", "nearest", false) + "," +
               input(30, "texture", 2, "/media/a/" + red),
           "void mainImage(out vec4 c, in vec2 p) { c = p.y < 1. ? vec4(texelFetch(iChannel0, ivec2(0), "
           "0).x, texelFetch(iChannel1, ivec2(0), 0).x, textureLod(iChannel0, vec2(.49, .25), 0.).x, 1) : "
           "p.y < 2. ? texelFetch(iChannel2, ivec2(1), 0) : vec4(textureGrad(iChannel0, vec2(.49, .25), "
           "vec2(4), vec2(4)).x, textureLod(iChannel0, vec2(.51, .75), 0.).x, 0, 1); }")));
  const Image drawn = pictures(project, 1)[0];
  const auto byte = [](int value) { return static_cast<float>(value) / 255.0F; };
  EXPECT_EQ(pixel(drawn, 0, 0), glm::vec4(byte(128), byte(168), byte(128), 1));
  EXPECT_EQ(pixel(drawn, 0, 1), glm::vec4(byte(188), 0, 0, 1));
  EXPECT_EQ(pixel(drawn, 0, 2), glm::vec4(byte(128), byte(188), 0, 1));
}

// vflip turns every face over and puts the top one at the bottom.
TEST_P(SiteInputs, ACubemapsFlipSwapsTopAndBottom) {
  for (int face = 0; face < 6; ++face) {
    Image image(2, 2);
    for (int i = 0; i < 4; ++i) {
      image.at(i % 2, i / 2)[0] = static_cast<float>(10 * face + i / 2) / 255.0F;
      image.at(i % 2, i / 2)[3] = 1.0F;
    }
    write_image(image, folder / ("sky" + (face == 0 ? "" : "_" + std::to_string(face)) + ".png"));
  }
  const auto faces = [&](bool vflip) {
    const Image image = pictures(
        load_project(json(
            "cube.json",
            pass("image", 37, input(21, "cubemap", 0, "/media/a/sky.png", "nearest", vflip),
                 "void mainImage(out vec4 c, in vec2 p) { vec3 axes[6] = vec3[6](vec3(1, .5, 0), "
                 "vec3(-1, .5, 0), vec3(0, 1, .5), vec3(0, -1, .5), vec3(0, .5, 1), vec3(0, .5, -1)); c = "
                 "textureLod(iChannel0, axes[int(p.x)], 0.); }"))),
        1, 6, 1)[0];
    std::vector<int> values;
    for (int x = 0; x < 6; ++x) values.push_back(static_cast<int>(std::lround(pixel(image, x).x * 255)));
    return values;
  };
  const std::vector<int> plain = faces(false);
  const std::vector<int> flipped = faces(true);
  for (int face = 0; face < 6; ++face) EXPECT_EQ(plain[static_cast<std::size_t>(face)] / 10, face);
  EXPECT_EQ(flipped[2] / 10, 3);
  EXPECT_EQ(flipped[3] / 10, 2);
  for (const std::size_t side : {0U, 1U, 4U, 5U})
    EXPECT_EQ(flipped[side] + plain[side], 20 * static_cast<int>(side) + 1);
}

// The API's spelling of a shader and the site's: ids as numbers or strings, ctype and src or type and
// filepath.
TEST_P(SiteInputs, BothSpellingsOfAJsonDrawTheSamePicture) {
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
TEST_P(SiteInputs, KeyboardChannelHasOneColourAndShowsAPressForOneFrame) {
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
  FixedClock clock(schedule, host_rules(project));
  for (int i = 0; i < 3; ++i) {
    player->render(clock.next());
    const Image image = player->read(0);
    const float rows[3][3] = {{0, 0, 0}, {1, 1, 1}, {1, 0, 1}};
    for (int y = 0; y < 3; ++y)
      EXPECT_EQ(pixel(image, 0, y), glm::vec4(rows[i][y], 0, 0, 1)) << "frame " << i << ", row " << y;
  }
}

SHADERTWIN_ON_EVERY_PLAYER(SiteInputs);

}  // namespace
}  // namespace shadertwin

// What shadertoy.com's passes and targets do, on every player.
#include "host/base/error.h"
#include "host/player/fixed_clock.h"
#include "host/text/load.h"
#include "tests/twin/every_player.h"

namespace shadertwin {
namespace {

using SiteRules = OnEveryPlayer;

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

// WebGL2 refuses to draw with a block that has no buffer.
TEST_P(SiteRules, APassWithAUniformBlockIsNotDrawn) {
  const std::string blocks =
      "layout(std140) uniform Light { vec4 colour; layout(row_major) mat4 place; float k[2]; } light[2];\n"
      "uniform Plain { highp vec3 tint; uniform ivec2 size; };\n";
  const std::string use =
      "c = light[1].colour + light[0].place[0] * light[0].k[1] + vec4(tint, size.x) + 1.;";
  folder.write("tabs/buffer_a.glsl", blocks + "void mainImage(out vec4 c, in vec2 p) { " + use + " }\n");
  folder.write("tabs/buffer_b.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.5); }\n");
  folder.write("tabs/image.glsl",
               "#iChannel0 \"buffer_a.glsl\"\n#iChannel1 \"buffer_b.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = texelFetch(iChannel0, ivec2(p), 0) + texelFetch(iChannel1, ivec2(p), 0);\n}\n");
  for (const Image& image : pictures(load_project(folder / "tabs"), 2))
    EXPECT_EQ(pixel(image), glm::vec4(0.5F, 0.5F, 0.5F, 1));
  const auto own = folder.write("a.glsl", blocks + "void mainImage(out vec4 c, in vec2 p) { " + use + " }\n");
  LoadOptions site;
  site.dialect = Dialect::shadertoy;
  EXPECT_EQ(glm::vec3(pixel(pictures(load_project(own, site), 1).back())), glm::vec3(0));
  const auto other =
      folder.write("b.frag", "uniform B { float x; };\nvoid main() { gl_FragColor = vec4(x + 1.); }\n");
  EXPECT_EQ(pixel(pictures(load_project(other), 1).back()).x, 0);
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

TEST_P(SiteRules, BuffersStartAtZeroAndKeepEveryFloat) {
  const std::string a =
      pass("buffer", 257, input(257, "buffer", 0),
           "void mainImage(out vec4 c, in vec2 p) { vec4 old = texelFetch(iChannel0, ivec2(p), 0); "
           "if (iFrame == 0) c = p.x < 1. ? old : vec4(-3.5, 1000.25, 1e30, -1e-30); else c = p.x < 1. "
           "? vec4(old.a, old.r, 7, 8) : old; }");
  const std::string b =
      pass("buffer", 258, input(258, "buffer", 0),
           "void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); if (iFrame "
           "== 0) c += 1.; }");
  const Project project = load_project(json(
      "floats.json", a + "," + b + "," + pass("image", 37, "", "void mainImage(out vec4 c, in vec2 p) {}")));
  const auto player = play(project);
  for (int i = 0; i < 4; ++i) {
    player->render(frame(i));
    EXPECT_EQ(pixel(player->read(0), 0), i == 0   ? glm::vec4(0)
                                         : i == 1 ? glm::vec4(0, 0, 7, 8)
                                                  : glm::vec4(8, i == 2 ? 0 : 8, 7, 8))
        << i;
    EXPECT_EQ(pixel(player->read(0), 1), glm::vec4(-3.5F, 1000.25F, 1e30F, -1e-30F)) << i;
    EXPECT_EQ(pixel(player->read(1), 2), glm::vec4(1)) << "frame 0 is drawn once, frame " << i;
  }
}

// The picture's alpha is 1, a buffer's its own; what nothing writes is 0, and an index stays in its array.
TEST_P(SiteRules, AlphaAndWhatNothingWrites) {
  const std::string buffer = pass("buffer", 257, "",
                                  "float none(float x) { if (x > 1e9) return 1.; } void half_of(out vec4 v) "
                                  "{ v.x = .5; } void mainImage(out vec4 "
                                  "c, in vec2 p) { float a[3] = float[3](1., 2., 3.); int n = int(p.x); vec4 "
                                  "local; half_of(c); if (n > 0) c = "
                                  "vec4(a[100 + n], none(p.x), local.y, .25); }");
  const Project project =
      load_project(json("alpha.json", buffer + "," +
                                          pass("image", 37, input(257, "buffer", 0),
                                               "void mainImage(out vec4 c, in vec2 p) { c = vec4(.5, .5, "
                                               "texelFetch(iChannel0, ivec2(p), 0).a, .25); }")));
  const auto player = play(project);
  player->render(frame(0));
  EXPECT_EQ(pixel(player->read(0), 0), glm::vec4(.5F, 0, 0, 0));
  EXPECT_EQ(pixel(player->read(0), 1), glm::vec4(3, 0, 0, .25F));
  EXPECT_EQ(pixel(player->read(1), 1), glm::vec4(.5F, .5F, .25F, 1));
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

// The hand presses in frame 2 in the upper left corner and lets go in frame 4; the clock stands half a second
// before February.
TEST_P(SiteRules, MouseDateAndTimeOfTheFirstFrames) {
  folder.write("tabs/buffer_a.glsl",
               "void mainImage(out vec4 c, in vec2 p) {\n"
               "  c = p.x < 1. ? iMouse : p.x < 2. ? iDate : p.x < 3. ? vec4(iTimeDelta, iFrame, iTime, "
               "iFrameRate) :\n"
               "      vec4(floatBitsToUint(iMouse.zw) >> 31, iResolution.z, iSampleRate);\n}\n");
  folder.write("tabs/image.glsl", "void mainImage(out vec4 c, in vec2 p) {}\n");
  const Project project = load_project(folder / "tabs");
  const auto player = play(project);
  Schedule schedule;
  schedule.width = 4;
  schedule.height = 3;
  schedule.fps = 4.0;
  schedule.date = Date::parse("2024-01-31T23:59:59.5");
  schedule.mouse = {{2, {0.25, 3.0}, true}, {3, {3.75, 1.5}, true}, {4, {3.75, 1.5}, false}};
  FixedClock clock(schedule, host_rules(project));
  const glm::vec4 mouse[] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 3, 0, 3}, {3, 1, 0, -3}, {3, 1, 0, -3}};
  const glm::vec4 date[] = {{2024, 0, 31, 86399.5F},
                            {2024, 0, 31, 86399.75F},
                            {2024, 1, 1, 0},
                            {2024, 1, 1, .25F},
                            {2024, 1, 1, .5F}};
  const float negative[][2] = {
      {1, 1}, {1, 1}, {0, 0}, {0, 1}, {1, 1}};  // the signs of z and w, also of zeros
  for (int i = 0; i < 5; ++i) {
    player->render(clock.next());
    const Image image = player->read(0);
    EXPECT_EQ(pixel(image, 0), mouse[i]) << "frame " << i;
    EXPECT_EQ(pixel(image, 1), date[i]) << "frame " << i;
    EXPECT_EQ(pixel(image, 2),
              glm::vec4(i == 0 ? 1.0F / 60.0F : .25F, i, .25F * static_cast<float>(i), pixel(image, 2).w));
    EXPECT_EQ(pixel(image, 3), glm::vec4(negative[i][0], negative[i][1], 1, 44100)) << "frame " << i;
  }
}

// Braces and parentheses that a macro opens or closes hide neither what is global nor what is not.
TEST_P(SiteRules, MacrosMayOpenWhatTheTextCloses) {
  folder.write("tabs/buffer_a.glsl",
               "#define RISE smoothstep(0., 4.,\n#define LOOP for (int i = 0; i < 3; ++i) {\n"
               "float f(float x) { float sum = 0.; LOOP sum += RISE x); } return sum; }\n"
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(f(2.), iTime, 0, 1); }\n");
  folder.write("tabs/image.glsl",
               "#define END }\nfloat g() { return 2.; END\n#iChannel0 \"buffer_a.glsl\"\n"
               "void mainImage(out vec4 c, in vec2 p) { c = g() * texelFetch(iChannel0, ivec2(p), 0); }\n");
  EXPECT_EQ(pixel(pictures(load_project(folder / "tabs"), 1)[0], 1, 1), glm::vec4(3, 0, 0, 1));
}

SHADERTWIN_ON_EVERY_PLAYER(SiteRules);

}  // namespace
}  // namespace shadertwin

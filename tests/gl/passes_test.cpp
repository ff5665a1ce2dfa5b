// Pass order, ping-pong, and what buffers keep.
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

using Passes = OnEveryDevice;

TEST_P(Passes, EarlierPassesAreReadFromThisFrameAndLaterOnesFromTheLast) {
  // A reads B, which draws after it; both write their frame number.
  folder.write("tabs/buffer_a.glsl", R"(
#iChannel0 "buffer_b.glsl"
void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame) + 1., texelFetch(iChannel0, ivec2(p), 0).x, 0, 1); }
)");
  folder.write("tabs/buffer_b.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = vec4(float(iFrame) + 1., texelFetch(iChannel0, ivec2(p), 0).x, 0, 1); }
)");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
#iChannel1 "buffer_b.glsl"
void mainImage(out vec4 c, in vec2 p) {
  c = vec4(texelFetch(iChannel0, ivec2(p), 0).xy, texelFetch(iChannel1, ivec2(p), 0).y, 1);
}
)");
  const auto images = frames(load_project(folder / "tabs"), 3, small());
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(pixel(images[static_cast<std::size_t>(i)]), glm::vec4(i + 1, i, i + 1, 1)) << "frame " << i;
}

TEST_P(Passes, ReadingItselfGivesThePreviousFrame) {
  const auto shader = folder.write("sum.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + vec4(1, float(iFrame), 0, 0); }
)");
  const auto images = frames(load_project(shader), 5, small());
  EXPECT_EQ(pixel(images[0]), glm::vec4(1, 0, 0, 0));
  EXPECT_EQ(pixel(images[4]), glm::vec4(5, 10, 0, 0));
}

TEST_P(Passes, BuffersStartAtZeroWithTheirAlpha) {
  folder.write("tabs/buffer_a.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) { c = iFrame == 0 ? texelFetch(iChannel0, ivec2(p), 0) : vec4(9); }
)");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = vec4(texelFetch(iChannel0, ivec2(p), 0).a); }
)");
  const auto images = frames(load_project(folder / "tabs"), 2, small());
  EXPECT_EQ(pixel(images[0]), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(pixel(images[1]), glm::vec4(9, 9, 9, 1));
}

TEST_P(Passes, FrameZeroClearsWhatAnEarlierRunLeft) {
  const auto shader = folder.write("sum.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) + 1.; }
)");
  const Project project = load_project(shader);
  const auto player = play(project);
  for (int run = 0; run < 2; ++run) {
    FixedClock clock(small(), host_rules(project));
    for (int i = 0; i < 3; ++i) player->render(clock.next());
    EXPECT_EQ(pixel(player->read(0)), glm::vec4(3)) << "run " << run;
  }
}

TEST_P(Passes, ReadingBetweenFramesChangesNothing) {
  const auto shader = folder.write("sum.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) * 1.1 + vec4(p, iTime, 1); }
)");
  const Project project = load_project(shader);
  const Image watched = frames(project, 6, small()).back();
  const auto player = play(project);
  FixedClock clock(small(), host_rules(project));
  for (int i = 0; i < 6; ++i) player->render(clock.next());
  EXPECT_EQ(player->read(0).rgba, watched.rgba);
}

TEST_P(Passes, DiscardKeepsTheBufferOfTwoFramesAgoOnTheSite) {
  folder.write("tabs/buffer_a.glsl", R"(
void mainImage(out vec4 c, in vec2 p) {
  if (iFrame % 2 == 1) discard;
  c = vec4(float(iFrame) + 1.);
}
)");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }
)");
  const auto images = frames(load_project(folder / "tabs"), 4, small());
  EXPECT_EQ(pixel(images[0]).x, 1);
  EXPECT_EQ(pixel(images[1]).x, 0);  // the other picture, still clear
  EXPECT_EQ(pixel(images[2]).x, 3);
  EXPECT_EQ(pixel(images[3]).x, 0);
}

TEST_P(Passes, DiscardClearsInTheExtension) {
  const auto shader = folder.write("half.glsl", R"(
void mainImage(out vec4 c, in vec2 p) {
  if (iFrame == 1) discard;
  c = vec4(1);
}
)");
  const auto images = frames(load_project(shader), 2, small());
  EXPECT_EQ(pixel(images[0]), glm::vec4(1));
  EXPECT_EQ(pixel(images[1]), glm::vec4(0));
}

TEST_P(Passes, GrowingKeepsTheLowerLeftPixelsOnTheSite) {
  folder.write("tabs/buffer_a.glsl", R"(
#iChannel0 "self"
void mainImage(out vec4 c, in vec2 p) { c = iFrame == 0 ? vec4(p, 0, 1) : texelFetch(iChannel0, ivec2(p), 0); }
)");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0); }
)");
  const Project project = load_project(folder / "tabs");
  const auto player = play(project);
  Frame frame;
  frame.width = 4;
  frame.height = 3;
  player->render(frame);
  frame.index = 1;
  player->render(frame);
  frame.width = 6;
  frame.height = 5;
  frame.index = 2;
  player->render(frame);
  const Image image = player->read(1);
  ASSERT_EQ(image.width, 6);
  EXPECT_EQ(pixel(image, 3, 2), glm::vec4(3.5F, 2.5F, 0, 1));
  EXPECT_EQ(pixel(image, 4, 2), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(pixel(image, 0, 3), glm::vec4(0, 0, 0, 1));
}

TEST_P(Passes, MipmapsOfABufferAreThoseOfThisFrame) {
  folder.write("tabs/buffer_a.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(p.x < 4. ? 2. : 4.) * float(iFrame + 1); }");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
#iChannel0::MinFilter "LinearMipMapLinear"
void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec2(.5), 9.); }
)");
  const auto images = frames(load_project(folder / "tabs"), 2, small(8, 8));
  EXPECT_EQ(pixel(images[0]).x, 3);
  EXPECT_EQ(pixel(images[1]).x, 6);
}

// A pass that comes later has not drawn yet in frame 0, and what it drew before a restart is gone.
TEST_P(Passes, MipmapsOfAClearedBufferAreZero) {
  folder.write("tabs/buffer_a.glsl", R"(
#iChannel0 "buffer_a.glsl"
#iChannel0::MinFilter "LinearMipMapLinear"
void mainImage(out vec4 c, in vec2 p) { c = textureLod(iChannel0, vec2(.5), 9.) + 4.; }
)");
  folder.write("tabs/image.glsl", R"(
#iChannel0 "buffer_a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(0), 0); }
)");
  const Project project = load_project(folder / "tabs");
  const auto player = gl::make_player(gl::open_context(GetParam().name), project, {GetParam().dispatch});
  for (int run = 0; run < 2; ++run) {
    FixedClock clock(small(8, 8), host_rules(project));
    player->render(clock.next());
    EXPECT_EQ(pixel(player->read(1)).x, 4) << "run " << run;
    player->render(clock.next());
    EXPECT_EQ(pixel(player->read(1)).x, 8) << "run " << run;
  }
}

TEST_P(Passes, TimersMeasureEveryPassWithoutChangingThePicture) {
  folder.write("a.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(p, iTime, 1); }");
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "a.glsl"
void mainImage(out vec4 c, in vec2 p) { c = texelFetch(iChannel0, ivec2(p), 0) * 2.; }
)");
  const Project project = load_project(shader);
  auto made =
      std::make_unique<gl::GlDevice>(gl::open_context(GetParam().name), project,
                                     gl::PlayerOptions{.dispatch = GetParam().dispatch, .timers = true});
  gl::GlDevice& device = *made;
  Player timed(std::move(made));
  FixedClock clock(small(), host_rules(project));
  for (int i = 0; i < 8; ++i) timed.render(clock.next());
  timed.finish();
  EXPECT_EQ(timed.read(1).rgba, frames(project, 8, small()).back().rgba);
  const auto times = device.milliseconds();
  if (!device.context().has_extension("GL_EXT_disjoint_timer_query")) {
    EXPECT_TRUE(times.empty());
    return;
  }
  ASSERT_EQ(times.size(), 2U);
  for (const double milliseconds : times) EXPECT_GE(milliseconds, 0.0);
}

SHADERTWIN_ON_EVERY_DEVICE(Passes);

}  // namespace
}  // namespace shadertwin

// `shadertwin render -o` with the name of a video.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host/media/audio_file.h"
#include "tests/app/command_line.h"
#include "tests/media/packets.h"

namespace shadertwin {
namespace {

constexpr const char* grain =
    "void mainImage(out vec4 c, in vec2 p) {\n"
    "  c = fract(sin(dot(p, vec2(12.9898, 78.233)) + iTime) * vec4(43758.5, 22578.1, 19642.3, 1));\n}\n";

class RenderVideo : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("clock.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime)); }\n");
  }
  ScratchFolder folder;
};

TEST_F(RenderVideo, WritesEveryFrameAndPrintsNothing) {
  for (const char* name : {"a.mp4", "a.webm"}) {
    const Outcome outcome = run(folder, std::string("render clock.glsl --size 32x16 --frames 7 -o ") + name);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err + outcome.out, "");
    EXPECT_EQ(media::read_packets(folder / name).times.size(), 7U) << name;
  }
}

TEST_F(RenderVideo, AGifTakesItsHighestRateUnlessAnotherIsGiven) {
  ASSERT_EQ(run(folder, "render clock.glsl --size 32x16 --frames 4 -o a.gif").err, "");
  EXPECT_NEAR(media::read_packets(folder / "a.gif").times.rbegin()->first, 3 / 50.0, 1e-9);
  const Outcome outcome = run(folder, "render clock.glsl --size 32x16 --frames 4 --fps 60 -o b.gif");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
}

TEST_F(RenderVideo, DurationIsAnotherWayToSayHowManyFrames) {
  ASSERT_EQ(run(folder, "render clock.glsl --size 32x16 --fps 8 --duration 0.5 -o a.mp4").err, "");
  EXPECT_EQ(media::read_packets(folder / "a.mp4").times.size(), 4U);
  ASSERT_EQ(run(folder, "render clock.glsl --size 32x16 --duration 0.1 -o b.gif").err, "");
  EXPECT_EQ(media::read_packets(folder / "b.gif").times.size(), 5U);
  ASSERT_EQ(run(folder, "render clock.glsl --size 2x2 --fps 10 --duration 0.3 -o f_%d.png").err, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "f_2.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "f_3.png"));
}

TEST_F(RenderVideo, QualityChangesTheSize) {
  folder.write("grain.glsl", grain);
  ASSERT_EQ(run(folder, "render grain.glsl --size 64x64 --frames 3 --crf 45 -o a.mp4").err, "");
  ASSERT_EQ(run(folder, "render grain.glsl --size 64x64 --frames 3 --crf 4 -o b.mp4").err, "");
  EXPECT_GT(std::filesystem::file_size(folder / "b.mp4"), 2 * std::filesystem::file_size(folder / "a.mp4"));
}

TEST_F(RenderVideo, HoldsTheSoundOfItsFramesUnlessMuted) {
  folder.write("toy/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  folder.write("toy/sound.glsl", "vec2 mainSound(in int s, float t) { return vec2(sin(2764. * t), .5); }\n");
  ASSERT_EQ(run(folder, "render toy --size 16x16 --frames 7 -o a.webm").err, "");
  const media::Sound sound = media::decode_sound(folder / "a.webm");
  EXPECT_EQ(sound.samples, 7 * 48000 / 60);
  EXPECT_EQ(media::read_packets(folder / "a.webm").times.size(), 7U);
  ASSERT_EQ(run(folder, "render toy --size 16x16 --frames 7 --mute -o b.webm").err, "");
  EXPECT_TRUE(media::read_packets(folder / "b.webm", AVMEDIA_TYPE_AUDIO).times.empty());
  ASSERT_EQ(run(folder, "render toy --size 16x16 --frames 7 -o c.gif").err, "");
}

TEST_F(RenderVideo, HoldsTheSoundOfVideosInTheirLoop) {
  folder.write("toy/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(1); }\n");
  folder.write("toy/sound.glsl",
               "vec2 mainSound(in int s, float t) { return vec2(sin(2764. * t)) * step(t, .25); }\n");
  ASSERT_EQ(run(folder, "render toy --size 16x16 --frames 30 -o film.webm").err, "");
  ASSERT_EQ(run(folder, "render clock.glsl --size 16x16 --frames 30 -o silent.webm").err, "");
  const auto show = [&](const std::string& film) {
    folder.write("show.glsl",
                 "#iChannel0 \"" + film +
                     "\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
    return run(folder, "render show.glsl --size 16x16 --frames 90 -o shown.webm").err;
  };
  ASSERT_EQ(show("film.webm"), "");
  media::AudioFile file(folder / "shown.webm", 44100);
  // Of each quarter of a second: half a second of the film has sound in its first half.
  for (int quarter = 0; quarter < 6; ++quarter) {
    std::vector<float> stereo(std::size_t{2} * 8820);
    file.read(quarter * 11025 + 1100, stereo);
    double power = 0.0;
    for (const float value : stereo) power += value * value / static_cast<double>(stereo.size());
    EXPECT_NEAR(std::sqrt(power), quarter % 2 == 0 ? 0.7071 : 0.0, 0.05) << quarter;
  }
  ASSERT_EQ(show("silent.webm"), "");
  EXPECT_TRUE(media::read_packets(folder / "shown.webm", AVMEDIA_TYPE_AUDIO).times.empty());
}

TEST_F(RenderVideo, RefusalsAreOneLineAndLeaveNothing) {
  const auto expect = [&](int status, const std::string& arguments, const std::string& word,
                          const std::string& before = "") {
    const Outcome outcome = run(folder, "render clock.glsl " + arguments, before);
    EXPECT_EQ(outcome.status, status) << arguments << '\n' << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << arguments << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
    EXPECT_EQ(files, 1U) << arguments;
  };
  expect(2, "--size 33x16 -o a.mp4", "even");
  expect(2, "--size 32x16 -o a.avi", ".webm");
  expect(2, "--size 32x16 --crf 70 -o a.webm", "63");
  expect(2, "--size 32x16 --crf 20 -o a.png", "--crf");
  expect(2, "--size 32x16 --chroma 422 -o a.mp4", "--chroma");
  expect(4, "--size 32x16 -o nowhere/a.mp4", "nowhere");
  // A disk that fills up.
  folder.write("clock.glsl", grain);
  for (const char* options : {"--crf 0 -o a.mp4", "--crf 0 -o a.webm", "-o a.gif"})
    expect(4, std::string("--size 128x128 --frames 3 ") + options, "can't be written",
           "trap '' XFSZ; ulimit -f 8;");
}

TEST_F(RenderVideo, CtrlCLeavesNothing) {
  folder.write("a.mp4", "old");
  const Outcome outcome = run(folder, "render clock.glsl --size 32x16 --frames 1000000 -o a.mp4",
                              "timeout --preserve-status -s INT 1");
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(contents(folder / "a.mp4"), "old");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 2U);
}

TEST(VideoInput, IsTheSameForOpenGlAndTheTwin) {
  const ScratchFolder folder;
  folder.write("rings.glsl",
               "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(length(p) * .1 - iTime * vec3(1, 2, "
               "3)), 1); }\n");
  ASSERT_EQ(run(folder, "render rings.glsl --size 48x32 --frames 8 --fps 8 -o a.mp4").err, "");
  folder.write(
      "show.glsl",
      "#iChannel0 \"a.mp4\"\n#iChannel0::MinFilter \"LinearMipMapLinear\"\n"
      "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy * 3.); }\n");
  const Outcome outcome =
      run(folder, "compare show.glsl --on llvmpipe --on cpu --size 32x32 --frames 11 --fps 8 --json r.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("r   100.0000 %"), std::string::npos) << outcome.out;
}

TEST(VideoInput, BadFilesAreOneLine) {
  const ScratchFolder folder;
  folder.write(
      "show.glsl",
      "#iChannel0 \"a.mp4\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
  for (const char* content : {"", "no video"}) {
    folder.write("a.mp4", content);
    const Outcome outcome = run(folder, "render show.glsl --size 4x4 -o a.png");
    EXPECT_EQ(outcome.status, 4);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("a.mp4"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace shadertwin

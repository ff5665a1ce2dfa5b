// The Sound pass on the GPU.
#include "host/player/sound.h"

#include "host/base/error.h"
#include "host/text/load.h"
#include "tests/gl/play.h"

namespace shadertwin {
namespace {

class SoundPass : public OnEveryDevice {
 protected:
  Project project(const std::string& sound) const {
    folder.write("toy/image.glsl", "void mainImage(out vec4 c, vec2 p) { c = vec4(iTime); }");
    folder.write("toy/sound.glsl", sound);
    return load_project(folder.path() / "toy");
  }
  // `count` samples from number `first` on.
  std::vector<float> samples(const std::string& sound, std::int64_t first, std::size_t count) const {
    const auto player = play(sound_only(project(sound)));
    std::vector<float> stereo(2 * count);
    Sound(*player, {2024, 0, 1, 12.75}, first).read(stereo);
    return stereo;
  }
};

TEST_P(SoundPass, SamplesAreNumberedAndTimedAcrossBlocks) {
  const auto stereo =
      samples("vec2 mainSound(int samp, float time) { return vec2(float(samp) / 1e6, time / 100.); }",
              sound_block_samples - 2, 4);
  for (int i = 0; i < 4; ++i) {
    const int sample = sound_block_samples - 2 + i;
    EXPECT_EQ(stereo[static_cast<std::size_t>(2 * i)], static_cast<float>(sample) / 1e6F) << i;
    EXPECT_NEAR(stereo[static_cast<std::size_t>(2 * i + 1)], sample / 44100.0 / 100.0, 1e-8) << i;
  }
}

TEST_P(SoundPass, TheOldFormTakesTheTimeAlone) {
  EXPECT_NEAR(samples("vec2 mainSound(float time) { return vec2(time); }", 22050, 1)[1], 0.5, 1e-6);
}

TEST_P(SoundPass, TheNewFormIsCalledWhereBothAreThere) {
  EXPECT_NEAR(samples("vec2 mainSound(float time) { return vec2(time); }\n"
                      "vec2 mainSound(in int samp, float time) { return .5 * mainSound(time); }",
                      22050, 1)[1],
              0.25, 1e-6);
}

TEST_P(SoundPass, HasTheDateInWholeSecondsAndTheRate) {
  const auto stereo = samples(
      "vec2 mainSound(int samp, float time) { return vec2(iDate.w / 100., iSampleRate / 1e5); }", 0, 1);
  EXPECT_FLOAT_EQ(stereo[0], 0.12F);
  EXPECT_FLOAT_EQ(stereo[1], 0.441F);
}

TEST_P(SoundPass, ValuesBeyondOneAreClippedNanIsSilentAndSoIsWhatComesBeforeTheStart) {
  const auto player =
      play(sound_only(project("vec2 mainSound(int samp, float time) { return samp == 0 ? vec2(3, -3) : "
                              "vec2(sqrt(-1. - time), .5); }")));
  Sound sound(*player, {}, -1);
  std::vector<float> stereo(6);
  sound.read(stereo);
  EXPECT_EQ(stereo, (std::vector<float>{0, 0, 1, -1, 0, 0.5F}));
  EXPECT_EQ(sound.clipped_values(), 2);
  EXPECT_EQ(sound.nan_values(), 1);
}

TEST_P(SoundPass, ReadsTexturesAndLeavesPicturesAlone) {
  Image picture(1, 1);
  picture.rgba = {0.25F, 0.5F, 0, 1};
  folder.write("toy/dot.exr", "");
  write_image(picture, folder / "toy/dot.exr");
  const auto player =
      play(project("#iChannel1 \"dot.exr\"\nvec2 mainSound(int samp, float time) { return texture(iChannel1, "
                   "vec2(.5)).rg; }"));
  player->render(FixedClock(small(), host_rules(Dialect::shadertoy)).next());
  const Image before = player->read(1);
  std::vector<float> stereo(2);
  Sound(*player, {}).read(stereo);
  EXPECT_EQ(stereo, (std::vector<float>{0.25F, 0.5F}));
  EXPECT_EQ(player->read(1).rgba, before.rgba);
}

TEST_P(SoundPass, FailsWithoutOneAndOnWhatDoesNotCompile) {
  folder.write("toy/image.glsl", "void mainImage(out vec4 c, vec2 p) { c = vec4(1); }");
  EXPECT_THROW(sound_only(load_project(folder.path() / "toy")), Error);
  try {
    samples("vec2 mainSound(int samp, float time) {\n  return vec2(tone); }", 0, 1);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), ExitStatus::shader);
    EXPECT_NE(std::string(e.what()).find("sound.glsl:2: error: "), std::string::npos) << e.what();
  }
}

SHADERTWIN_ON_EVERY_DEVICE(SoundPass);

}  // namespace
}  // namespace shadertwin

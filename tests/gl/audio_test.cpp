// Music and the microphone as textures on the GPU.
#include <cmath>

#include "host/text/load.h"
#include "tests/gl/play.h"
#include "tests/media/wav_file.h"

namespace shadertwin {
namespace {

using Audio = OnEveryDevice;

// Texel (x, y) of the picture is texel (64 x, y) of the music, iChannelTime and the width in blue and alpha.
Project music_shader(const ScratchFolder& folder, bool muted) {
  const auto shader =
      folder.write("toy.json", R"({"Shader": {"renderpass": [{"type": "image", "name": "Image",
    "outputs": [{"id": 37, "channel": 0}],
    "inputs": [{"id": 1, "channel": 1, "ctype": "music", "src": "/media/a/none.mp3"}],
    "code": "void mainImage(out vec4 c, vec2 p) { c.rg = texelFetch(iChannel1, ivec2(p) * ivec2(64, 1), 0).rg; c.b = iChannelTime[1] + texelFetch(iChannel1, ivec2(p), 0).b; }"}]}})");
  return load_project(shader, {.settings = {.muted = muted}});
}

TEST_P(Audio, MissingMusicIsSilent) {
  const Project project = music_shader(folder, false);
  ASSERT_EQ(project.warnings.size(), 1U);
  const Image image = frames(project, 1, small(8, 2))[0];
  EXPECT_EQ(pixel(image, 3, 0), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(pixel(image, 3, 1), glm::vec4(128.0F / 255, 0, 0, 1));
}

TEST_P(Audio, MutedMusicIsTheSitesPreview) {
  Schedule schedule = small(8, 2);
  schedule.t0 = 0.5;
  schedule.fps = 2.0;
  const std::vector<Image> images = frames(music_shader(folder, true), 2, schedule);
  // The beat of the lowest bins is off half-way between two seconds, and on at each.
  EXPECT_NEAR(pixel(images[0], 0, 0).x, std::pow(0.5 + 0.5 * std::sin(M_PI), 4.0), 1.0 / 255);
  EXPECT_NEAR(pixel(images[1], 0, 0).x, std::pow(0.5 + 0.5 * std::sin(2.0 * M_PI), 4.0), 1.0 / 255);
  EXPECT_NEAR(pixel(images[1], 2, 0).x, (0.75 + 0.25 * std::sin(10.0 * 128 + 13.0)) * std::exp(-0.75),
              1.0 / 255);
  EXPECT_NEAR(pixel(images[1], 0, 1).x, 0.5 + 0.15 * std::sin(17.0) * std::sin(23.0), 1.0 / 255);
  EXPECT_EQ(pixel(images[1], 0, 0).z, 11.0F);
}

// The extension's analyser: a window of 512, in grey, with the 256 levels twice each.
TEST_P(Audio, TheExtensionsTextureIsGreyAndOfASmallerWindow) {
  std::vector<float> wave(44100, 0.5F);
  for (std::size_t i = 0; i < 22050; ++i)
    wave[i] = 0.25F * std::sin(static_cast<float>(M_PI / 8 * double(i)));
  folder.write("tone.wav", wav_file(wave));
  const auto shader = folder.write("main.glsl", R"(
#iChannel0 "tone.wav"
void mainImage(out vec4 c, in vec2 p) {
  c = texelFetch(iChannel0, ivec2(p), 0);
  c.a = iSampleRate + iChannelResolution[0].x;
})");
  Schedule schedule = small(512, 2);
  schedule.t0 = 22050.0 / 44100.0;
  schedule.fps = 44100.0 / 512.0;
  const std::vector<Image> images = frames(load_project(shader), 2, schedule);
  // A sixteenth of the rate is the 32nd of 512 bins: columns 64 and 65.
  EXPECT_GT(pixel(images[0], 64, 0).x, 0.8F);
  EXPECT_EQ(pixel(images[0], 65, 0), pixel(images[0], 64, 0));
  EXPECT_EQ(pixel(images[0], 200, 0).x, 0.0F);
  const glm::vec4 half(glm::vec3(192.0F / 255), 44100);
  for (const int x : {0, 511}) EXPECT_LT(glm::distance(pixel(images[1], x, 1), half), 1e-6F) << x;
}

SHADERTWIN_ON_EVERY_DEVICE(Audio);

}  // namespace
}  // namespace shadertwin

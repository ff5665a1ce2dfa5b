// What is heard in the window. ALSA's own device that writes into a file stands in for a loudspeaker: it
// takes samples as fast as they come, so that what is in the file is what the window made, whatever the
// machine's load.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "tests/media/wav_file.h"
#include "tests/view/screen.h"

namespace shadertwin {
namespace {

constexpr float full = 4194304.0F;  // 2^22: sample n is n / full, exactly
constexpr int rate = 44100;

class SoundInTheWindow : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_FALSE(screen.name().empty()) << "no X server: apt install xvfb";
    folder.write("file.conf", "pcm.!default { type file slave.pcm { type null } file \"" + heard_file() +
                                  "\" format \"raw\" }\n");
    folder.write("none.conf", "");
    folder.write("toy/image.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(fract(iTime)); }\n");
    folder.write("toy/sound.glsl",
                 "vec2 mainSound(int samp, float time) { return vec2(1, -1) * float(samp) / 4194304.; }\n");
  }

  std::string heard_file() const { return (folder / "heard.raw").string(); }
  std::vector<std::string> with(const std::string& config) const {
    return {"ALSA_CONFIG_PATH=" + (folder / config).string()};
  }
  static std::vector<float> floats(const std::string& bytes, std::size_t from) {
    std::vector<float> values((bytes.size() - from) / sizeof(float));
    std::memcpy(values.data(), bytes.data() + from, values.size() * sizeof(float));
    return values;
  }
  static std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  // What was heard so far, left and right in turn.
  std::vector<float> heard() const {
    auto values = floats(contents(heard_file()), 0);
    values.resize(values.size() / 2 * 2);
    return values;
  }
  bool hears(double seconds) const {
    return eventually([&] { return static_cast<double>(heard().size()) >= 2 * seconds * rate; });
  }
  // Runs of samples that follow one another, as [first, past the last), by what the Sound pass above writes.
  static std::vector<std::pair<long, long>> runs(const std::vector<float>& stereo) {
    std::vector<std::pair<long, long>> found;
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
      const long number = std::lround(stereo[i] * full);
      if (found.empty() || found.back().second != number) found.emplace_back(number, number);
      ++found.back().second;
    }
    return found;
  }

  Screen screen;
  ScratchFolder folder;
};

TEST_F(SoundInTheWindow, IsSampleBySampleWhatRenderWrites) {
  RunningView view(screen, folder, "toy --size 64x36", with("file.conf"));
  ASSERT_TRUE(hears(7.0)) << view.err();  // beyond the first block
  EXPECT_EQ(view.quit(), 0) << view.err();
  const std::string command = "cd '" + folder.path().string() +
                              "' && '" SHADERTWIN_BINARY "' render toy --duration 60 --quiet -o a.wav";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string wav = contents(folder / "a.wav");
  const auto written = floats(wav, wav.find("data") + 8);
  const auto stereo = heard();
  for (std::size_t i = 0; i < stereo.size(); i += 2) {
    const auto number = static_cast<std::size_t>(std::lround(stereo[i] * full));
    ASSERT_LT(2 * number + 1, written.size());
    ASSERT_EQ(stereo[i], written[2 * number]) << i;
    ASSERT_EQ(stereo[i + 1], written[2 * number + 1]) << i;
  }
  long longest = 0;
  for (const auto& [first, end] : runs(stereo)) longest = std::max(longest, end - first);
  EXPECT_GT(longest, rate) << "without gaps, but where the machine stood still";
}

TEST_F(SoundInTheWindow, RestsWhilePausedAndFollowsAReset) {
  RunningView view(screen, folder, "toy --size 64x36", with("file.conf"));
  ASSERT_TRUE(hears(1.0)) << view.err();
  view.key("F6");
  view.shoot();
  std::size_t size = 0;
  EXPECT_TRUE(eventually([&] { return std::exchange(size, heard().size()) == heard().size(); }));
  const auto before = runs(heard());
  screen.hand("sleep 1");
  EXPECT_EQ(heard().size(), size) << "nothing is heard of a paused picture";
  view.key("F6");
  ASSERT_TRUE(eventually([&] { return heard().size() > size + rate; }));
  const auto after = runs(heard());
  ASSERT_GT(after.size(), before.size());
  EXPECT_NEAR(static_cast<double>(after[before.size()].first), static_cast<double>(before.back().second),
              rate / 2.0)
      << "it goes on where it stood, however long the pause was";
  view.key("F5");
  EXPECT_TRUE(eventually([&] { return runs(heard()).back().first < rate / 4; }))
      << runs(heard()).back().first;
  EXPECT_EQ(view.quit(), 0) << view.err();
}

TEST_F(SoundInTheWindow, GoesOffAndOnByAKeyWhileThePictureGoesOn) {
  RunningView view(screen, folder, "toy --size 64x36", with("file.conf"));
  ASSERT_TRUE(hears(0.5)) << view.err();
  view.key("shift+F6");
  ASSERT_TRUE(view.says("sound off")) << view.err();
  std::size_t size = 0;
  EXPECT_TRUE(eventually([&] { return std::exchange(size, heard().size()) == heard().size(); }));
  view.let_frames_pass();
  screen.hand("sleep 0.7");
  EXPECT_EQ(heard().size(), size);
  const long last = runs(heard()).back().second;
  view.key("shift+F6");
  ASSERT_TRUE(eventually([&] { return heard().size() > size + rate / 5; })) << view.err();
  EXPECT_GT(runs(heard()).back().first, last + rate / 4) << "in time with the picture again";
  EXPECT_EQ(view.quit(), 0);
}

TEST_F(SoundInTheWindow, GoesAtThePaceOfItsFrames) {
  // 64 x 36 pixels come at 60 Hz or slower: with a quarter of a second a frame, the picture runs fast.
  RunningView view(screen, folder, "toy --size 64x36 --fixed --fps 4", with("file.conf"));
  const auto fast = [&] {
    const auto stereo = heard();
    int steps = 0;
    for (std::size_t i = 2; i + 1 < stereo.size(); i += 2) {
      const float step = (stereo[i] - stereo[i - 2]) * full;
      steps += step > 1.5F && step < 25.0F ? 1 : 0;
      if (steps > rate / 4) return true;
    }
    return false;
  };
  EXPECT_TRUE(eventually(fast)) << view.err();
}

TEST_F(SoundInTheWindow, HasMusicToo) {
  std::vector<float> wave;
  for (int i = 0; i < 4410; ++i) wave.push_back(static_cast<float>(i) / 8192.0F);
  folder.write("ramp.wav", wav_file(wave));
  folder.write(
      "music.glsl",
      "#iChannel0 \"ramp.wav\"\nvoid mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n");
  RunningView view(screen, folder, "music.glsl --size 64x36", with("file.conf"));
  ASSERT_TRUE(hears(0.5)) << view.err();
  EXPECT_EQ(view.quit(), 0) << view.err();
  const auto stereo = heard();
  int rising = 0;
  for (std::size_t i = 2; i + 1 < stereo.size(); i += 2) {
    EXPECT_EQ(stereo[i], stereo[i + 1]);
    rising += std::abs(stereo[i] - stereo[i - 2] - 1.0F / 8192.0F) < 1e-6F ? 1 : 0;
  }
  EXPECT_GT(rising, static_cast<int>(stereo.size() / 2 * 9 / 10));
}

TEST_F(SoundInTheWindow, IsOneWarningWithoutALoudspeakerAndNothingWhenMuted) {
  {
    RunningView view(screen, folder, "toy --size 64x36", with("none.conf"));
    ASSERT_TRUE(view.says("warning: there is no loudspeaker (")) << view.err();
    view.shoot();
    view.key("F5");
    view.let_frames_pass();
    EXPECT_EQ(view.quit(), 0);
    std::size_t warnings = 0;
    for (std::size_t at = view.err().find("loudspeaker"); at != std::string::npos;
         at = view.err().find("loudspeaker", at + 1))
      ++warnings;
    EXPECT_EQ(warnings, 1U) << view.err();
  }
  RunningView view(screen, folder, "toy --size 64x36 --mute", with("file.conf"));
  ASSERT_TRUE(view.running());
  view.let_frames_pass();
  EXPECT_EQ(view.quit(), 0);
  EXPECT_FALSE(std::filesystem::exists(heard_file()));
}

TEST_F(SoundInTheWindow, ASavedSoundTabIsHeardInPlaceOfTheOldOneUnlessItHasErrors) {
  RunningView view(screen, folder, "toy --size 64x36", with("file.conf"));
  ASSERT_TRUE(hears(0.3)) << view.err();
  folder.write("toy/sound.glsl", "vec2 mainSound(int samp, float time) {\n  return vec2(time;\n}\n");
  ASSERT_TRUE(view.says("sound.glsl:2: error: ")) << view.err();
  const std::size_t size = heard().size();
  EXPECT_TRUE(eventually([&] { return heard().size() > size + rate; })) << "the old one goes on";
  EXPECT_GT(heard().back(), -1.0F);
  EXPECT_LT(heard().back(), 0.0F);
  folder.write("toy/sound.glsl", "vec2 mainSound(int samp, float time) { return vec2(.25, .5); }\n");
  EXPECT_TRUE(eventually([&] { return heard().back() == 0.5F; })) << view.err();
  EXPECT_EQ(view.quit(), 0);
}

}  // namespace
}  // namespace shadertwin

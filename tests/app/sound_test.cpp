// `shadertwin render` into sound, and from sound.
#include <gtest/gtest.h>

#include <cmath>

#include "host/image/image.h"
#include "tests/app/command_line.h"
#include "tests/image/volume_file.h"
#include "tests/media/wav_file.h"

namespace shadertwin {
namespace {

class SoundCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("toy/image.glsl", "void mainImage(out vec4 c, vec2 p) { c = vec4(1); }");
    folder.write(
        "toy/sound.glsl",
        "vec2 mainSound(int samp, float time) {\n"
        "  return vec2(sin(6.2831 * 440.0 * time) * exp(-fract(time)), fract(0.01 * float(samp)));\n}");
  }
  // A project of one pass that shows the texture of an input as it is.
  void write_json(const std::string& type, const std::string& file,
                  const std::string& color = "texelFetch(iChannel0, ivec2(p), 0)") {
    folder.write("toy.json",
                 R"({"Shader": {"renderpass": [{"type": "image", "name": "Image",
        "outputs": [{"id": 37, "channel": 0}], "inputs": [{"id": 1, "channel": 0, "ctype": ")" +
                     type + R"(", "src": "/media/a/)" + file +
                     R"("}], "code": "void mainImage(out vec4 c, vec2 p) { c = )" + color + R"(; }"}]}})");
  }
  // The samples in a .wav of ours: what follows the word data and a length.
  static std::string samples(const std::filesystem::path& file) {
    const std::string bytes = contents(file);
    const std::size_t data = bytes.find("data");
    return data == std::string::npos ? "" : bytes.substr(data + 8);
  }
  ScratchFolder folder;
};

TEST_F(SoundCommand, DevicesAndTheTwinPlayTheSameBits) {
  ASSERT_EQ(run(folder, "render toy --on llvmpipe --duration 0.5 -o a.wav").err, "");
  if (has_osmesa()) {
    ASSERT_EQ(run(folder, "render toy --on osmesa --duration 0.5 -o b.wav").err, "");
  }
  ASSERT_EQ(run(folder, "render toy --on cpu --duration 0.5 -o c.wav").err, "");
  const std::string expected = contents(folder / "a.wav");
  EXPECT_EQ(samples(folder / "a.wav").size(), std::size_t{22050} * 2 * sizeof(float));
  if (has_osmesa()) {
    EXPECT_TRUE(contents(folder / "b.wav") == expected);
  }
  EXPECT_TRUE(contents(folder / "c.wav") == expected);
}

TEST_F(SoundCommand, TimeSaysWhereItStarts) {
  ASSERT_EQ(run(folder, "render toy --duration 0.3 -o a.wav").err, "");
  ASSERT_EQ(run(folder, "render toy --time 0.1 --duration 0.2 -o b.wav").err, "");
  EXPECT_EQ(samples(folder / "b.wav"),
            samples(folder / "a.wav").substr(std::size_t{4410} * 2 * sizeof(float)));
}

TEST_F(SoundCommand, FailsInOneLineAndLeavesNothing) {
  const auto fails = [&](const std::string& arguments, int status, const std::string& words) {
    const Outcome outcome = run(folder, arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  fails("render toy --duration 0 -o a.wav", 2, "--duration");
  fails("render toy --duration 1e9 -o a.wav", 2, "--duration");
  fails("render toy -o a.ogg", 2, ".wav or .flac");
  fails("render toy --duration 1 -o none/a.wav", 4, "none");
  fails("render toy/image.glsl --duration 1 -o a.flac", 2, "no Sound pass");
  folder.write("toy/sound.glsl", "vec2 mainSound(int samp, float time) {\n  return vec2(time;\n}");
  fails("render toy --duration 1 -o a.wav", 3, "sound.glsl:2: error: ");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.wav"));
}

TEST_F(SoundCommand, SaysWhatWasClippedAndWhatIsNoNumber) {
  folder.write("toy/sound.glsl",
               "vec2 mainSound(int samp, float time) { return vec2(2, sqrt(-1. - time)); }");
  const Outcome outcome = run(folder, "render toy --duration 0.001 -o a.wav");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("44 samples are NaN"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("44 samples were beyond"), std::string::npos) << outcome.err;
}

TEST_F(SoundCommand, MusicIsTheSameOnTheTwin) {
  std::vector<float> wave;
  for (int i = 0; i < 4410; ++i)
    wave.push_back(0.5F * static_cast<float>(std::sin(2.0 * M_PI * 72.0 * i / 4410.0)));
  folder.write("m/tone.wav", wav_file(wave));
  write_json("music", "tone.wav");
  const std::string play = "render toy.json --media m --size 512x2 --frames 4 --time 0.2 ";
  ASSERT_EQ(run(folder, play + "--on llvmpipe -o a.exr").err, "");
  ASSERT_EQ(run(folder, play + "--on cpu -o b.exr").err, "");
  const Image image = read_image(folder / "a.exr");
  EXPECT_EQ(read_image(folder / "b.exr").rgba, image.rgba);
  EXPECT_GT(image.at(33, 0)[0], 0.9F);  // 72 waves in 4410 samples are 33.4 in 2048
  EXPECT_EQ(image.at(300, 0)[0], 0.0F);
}

TEST_F(SoundCommand, VolumesAreTheSameOnTheTwin) {
  std::string texels;
  for (unsigned i = 0; i < 512; ++i) texels += static_cast<char>(i * 2654435761U >> 24);
  folder.write("toy/noise.bin", volume_file({8, 8, 8}, 1, 0, texels));
  folder.write("toy/shadertoy.json",
               R"({"Image": {"iChannel0": {"volume": "noise.bin", "filter": "mipmap"}}})");
  folder.write("toy/image.glsl",
               "void mainImage(out vec4 c, vec2 p) {\n"
               "  vec3 q = vec3(p / 20., .3 + p.x * .01);\n"
               "  c = texture(iChannel0, 2. * q) + textureLod(iChannel0, q, 1.3) + texelFetch(iChannel0, "
               "ivec3(p, 5), 0);\n}");
  for (const char* on : {"llvmpipe", "cpu"})
    ASSERT_EQ(run(folder, std::string("render toy --size 8x8 --on ") + on + " -o " + on + ".exr").err, "");
  EXPECT_EQ(read_image(folder / "cpu.exr").rgba, read_image(folder / "llvmpipe.exr").rgba);
  EXPECT_GT(read_image(folder / "llvmpipe.exr").at(3, 3)[0], 0.0F);
}

TEST_F(SoundCommand, MissingMusicIsOneWarningAndNoneWhenMuted) {
  write_json("music", "none.mp3");
  const Outcome silent = run(folder, "render toy.json --size 8x2 -o a.exr");
  EXPECT_EQ(silent.status, 0);
  EXPECT_EQ(silent.error_lines(), 1) << silent.err;
  EXPECT_NE(silent.err.find("warning: \"/media/a/none.mp3\" is not in"), std::string::npos) << silent.err;
  EXPECT_EQ(run(folder, "render toy.json --mute --time 1 --size 8x2 -o b.exr").err, "");
  EXPECT_EQ(read_image(folder / "a.exr").at(5, 0)[0], 0.0F);
  EXPECT_GT(read_image(folder / "b.exr").at(5, 0)[0], 0.4F);
}

TEST_F(SoundCommand, DamagedMediaFailInOneLine) {
  const auto fails = [&](const std::string& type, const std::string& bytes, const std::string& words) {
    write_json(type, "m.bin", "vec4(p, 0, 1)");
    folder.write("m.bin", bytes);
    const Outcome outcome = run(folder, "render toy.json -o a.png");
    EXPECT_EQ(outcome.status, 4) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  const std::string wave = wav_file(std::vector<float>(1000, 0.5F));
  fails("music", "", "empty");
  fails("music", "no sound", "neither sound nor");
  fails("music", wave.substr(0, 2000), "breaks off");
  fails("volume", "", "not a volume");
  fails("volume", volume_file({4, 4, 4}, 1, 0, "short"), "takes 84 bytes");
}

// ALSA's own devices stand in: one that gives what is in a file, and none.
TEST_F(SoundCommand, TheMicrophoneIsHeardAndIfThereIsNoneOneWarningSaysSo) {
  write_json("mic", "");
  std::string raw;
  for (int i = 0; i < 4410; ++i) {
    const float value = 0.5F * std::sin(0.1F * static_cast<float>(i));
    raw.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  folder.write("mic.raw", raw);
  folder.write("asound.conf",
               "pcm.!default { type file slave.pcm { type null } file \"/dev/null\" infile \"" +
                   (folder / "mic.raw").string() + "\" format \"raw\" }\n");
  folder.write("none.conf", "");
  const std::string play = "render toy.json --size 512x2 --frames 3 -o a.exr";
  const std::string config = "ALSA_CONFIG_PATH='" + folder.path().string() + "'/";
  EXPECT_EQ(run(folder, play, config + "asound.conf").err, "");
  EXPECT_GT(read_image(folder / "a.exr").at(33, 0)[0], 0.5F);
  const Outcome none = run(folder, play, config + "none.conf");
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(none.error_lines(), 1) << none.err;
  EXPECT_EQ(read_image(folder / "a.exr").at(33, 0)[0], 0.0F);
}

}  // namespace
}  // namespace shadertwin

// Sound in, out and analysed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "host/base/error.h"
#include "host/media/analyser.h"
#include "host/media/audio_file.h"
#include "host/media/audio_writer.h"
#include "tests/media/wav_file.h"
#include "tests/scratch_folder.h"

namespace shadertwin::media::audio_test {
namespace {

constexpr int rate = 44100;

std::string bytes_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<float> read(AudioFile& file, std::int64_t first, std::size_t count) {
  std::vector<float> stereo(2 * count);
  file.read(first, stereo);
  return stereo;
}

// 0, 1, 2 ... over 1000.
std::vector<float> ramp(std::size_t count) {
  std::vector<float> samples(count);
  for (std::size_t i = 0; i < count; ++i) samples[i] = static_cast<float>(i % 1000) / 1000.0F;
  return samples;
}

int level(double magnitude) {
  return static_cast<int>(std::floor(255.0 / 70.0 * (20.0 * std::log10(magnitude) + 100.0)));
}

// The window has the Fourier coefficients 0.42, 0.25 and 0.04: so much of half of a sine's height is in its
// bin and in the next two on either side, and nothing in the others.
TEST(Analyser, ASineIsSpreadByTheBlackmanWindow) {
  Analyser analyser(2048);
  std::vector<float> sine(2048);
  for (std::size_t i = 0; i < sine.size(); ++i)
    sine[i] =
        static_cast<float>(0.01 * std::sin(2.0 * std::numbers::pi * 100.0 * static_cast<double>(i) / 2048.0));
  analyser.hear(sine);
  std::vector<std::uint8_t> bins(512);
  analyser.spectrum(bins);
  const double first = 0.2 * 0.01 / 2.0;  // smoothing from silence
  EXPECT_EQ(bins[100], level(first * 0.42));
  EXPECT_EQ(bins[99], level(first * 0.25));
  EXPECT_EQ(bins[101], level(first * 0.25));
  EXPECT_EQ(bins[98], level(first * 0.04));
  EXPECT_EQ(bins[102], level(first * 0.04));
  EXPECT_EQ(bins[97], 0);
  EXPECT_EQ(bins[103], 0);
  for (int i = 0; i < 4; ++i) analyser.hear(sine);
  analyser.spectrum(bins);
  EXPECT_EQ(bins[100], level((1.0 - std::pow(0.8, 5.0)) * 0.01 / 2.0 * 0.42));
  analyser.hear(std::vector<float>(2048));
  analyser.spectrum(bins);
  EXPECT_EQ(bins[100], level(0.8 * (1.0 - std::pow(0.8, 5.0)) * 0.01 / 2.0 * 0.42));
  analyser.reset();
  analyser.spectrum(bins);
  EXPECT_EQ(bins[100], 0);
}

TEST(Analyser, TheWaveIsTheOldestSamplesAsBytes) {
  Analyser analyser(2048);
  std::vector<float> samples(2048);
  samples[0] = -1.0F;
  samples[1] = 1.0F;
  samples[2] = 0.5F;
  samples[3] = -7.0F;
  samples[512] = 0.75F;
  analyser.hear(samples);
  std::vector<std::uint8_t> wave(512);
  analyser.wave(wave);
  EXPECT_EQ((std::vector<int>{wave[0], wave[1], wave[2], wave[3], wave[4], wave[511]}),
            (std::vector<int>{0, 255, 192, 0, 128, 128}));
}

TEST(AudioFile, OneChannelIsBothAndThereIsSilenceBeforeTheStart) {
  const ScratchFolder folder;
  AudioFile file(folder.write("a.wav", wav_file(ramp(5000))), rate);
  EXPECT_EQ(read(file, 4700, 2), (std::vector<float>{0.7F, 0.7F, 0.701F, 0.701F}));
  EXPECT_EQ(read(file, -1, 3), (std::vector<float>{0, 0, 0, 0, 0.001F, 0.001F}));
  EXPECT_EQ(file.mono_gain(), 0.5F);
}

TEST(AudioFile, IsPlayedAgainAndAgain) {
  const ScratchFolder folder;
  AudioFile file(folder.write("a.wav", wav_file(ramp(4410))), rate);
  EXPECT_EQ(read(file, 4409, 2), (std::vector<float>{0.409F, 0.409F, 0, 0}));
  EXPECT_EQ(read(file, 4410LL * 1000000 + 7, 1), (std::vector<float>{0.007F, 0.007F}));
  EXPECT_NEAR(file.seconds(), 0.1, 1e-9);
}

TEST(AudioFile, SixChannelsAreMixedAsInWebAudio) {
  const ScratchFolder folder;
  std::vector<float> samples;
  for (int i = 0; i < 4096; ++i) samples.insert(samples.end(), {0.1F, 0.2F, 0.04F, 0.9F, 0.01F, 0.03F});
  AudioFile file(folder.write("a.wav", wav_file(samples, {.channels = 6})), rate);
  const auto stereo = read(file, 100, 1);
  const double half_power = std::sqrt(0.5);
  EXPECT_NEAR(stereo[0], 0.1 + half_power * (0.04 + 0.01), 1e-6);
  EXPECT_NEAR(stereo[1], 0.2 + half_power * (0.04 + 0.03), 1e-6);
  EXPECT_NEAR(file.mono_gain() * (stereo[0] + stereo[1]), half_power * 0.3 + 0.04 + 0.5 * (0.01 + 0.03),
              1e-6);
}

TEST(AudioFile, AnotherRateIsConvertedWithoutChangingItsLength) {
  const ScratchFolder folder;
  std::vector<float> sine(48000);
  for (std::size_t i = 0; i < sine.size(); ++i)
    sine[i] =
        static_cast<float>(0.5 * std::sin(2.0 * std::numbers::pi * 441.0 * static_cast<double>(i) / 48000.0));
  AudioFile file(folder.write("a.wav", wav_file(sine, {.rate = 48000})), rate);
  EXPECT_NEAR(read(file, 22025, 1)[0], 0.5, 0.001);  // a quarter of a wave of 100 samples
  EXPECT_NEAR(read(file, 22050, 1)[0], 0.0, 0.001);
  read(file, 50000, 1);
  EXPECT_NEAR(file.seconds(), 1.0, 0.001);
}

TEST(AudioFile, WhatIsNoNumberIsSilence) {
  const ScratchFolder folder;
  AudioFile file(folder.write("a.wav", wav_file(std::vector<float>(4096, NAN))), rate);
  EXPECT_EQ(read(file, 0, 1), (std::vector<float>{0, 0}));
}

TEST(AudioFile, TakesALengthThatIsLeftOpen) {
  const ScratchFolder folder;
  AudioFile file(folder.write("a.wav", wav_file(ramp(4410), {.data_bytes = 0xffffffff})), rate);
  read(file, 10000, 1);
  EXPECT_NEAR(file.seconds(), 0.1, 1e-9);
}

TEST(AudioFile, FailsInOneLineOnWhatCannotBePlayed) {
  const ScratchFolder folder;
  const std::string whole = wav_file(ramp(44100));
  {
    AudioWriter writer(folder / "whole.flac", rate);
    writer.write(ramp(200000));
    writer.finish();
  }
  const std::string flac = bytes_of(folder / "whole.flac");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "empty"},
      {flac.substr(0, flac.size() / 2), "breaks off"},
      {"not sound at all, but a text that is long enough to be looked at", "neither sound nor"},
      {whole.substr(0, 30), ""},
      {whole.substr(0, 44), ""},
      {whole.substr(0, whole.size() / 2), "breaks off"},
      {wav_file(ramp(44100), {.data_bytes = 0x7ffffff0}), "breaks off"},
      {wav_file(ramp(1000), {.rate = 1}), "sample rate is 1 Hz"},
      {wav_file(ramp(1000), {.rate = 0}), ""},
      {wav_file(ramp(1000), {.channels = 0}), ""},
      {std::string("OggS\0\2", 6) + std::string(100, '\0'), ""},
      {"fLaC" + std::string(50, '\1'), ""},
      {"ID3\3" + std::string(2000, '\0'), ""},
      {"#EXTM3U\nhttp://example.org/a.mp3\n", "neither sound nor"},
  };
  for (const auto& [bytes, words] : cases) {
    const auto path = folder.write("a.mp3", bytes);
    try {
      AudioFile file(path, rate);
      ADD_FAILURE() << words << ": is taken for " << file.seconds() << " seconds of sound";
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), ExitStatus::file);
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_THROW(AudioFile(folder.path(), rate), Error);
  EXPECT_THROW(AudioFile(folder / "none.mp3", rate), Error);
  EXPECT_THROW(AudioFile("/dev/zero", rate), Error);
}

TEST(AudioWriter, WavKeepsTheFloatsAndFlacTwentyFourBits) {
  const ScratchFolder folder;
  std::vector<float> stereo;
  for (int i = 0; i < 10000; ++i)
    stereo.insert(stereo.end(),
                  {std::sin(0.01F * static_cast<float>(i)), 1.0F - 2.0F * static_cast<float>(i % 2)});
  for (const char* name : {"a.wav", "a.FLAC"}) {
    for (int round = 0; round < 2; ++round) {
      AudioWriter writer(folder / (round == 0 ? name : std::string("again") + name), rate);
      // Pieces of no particular size.
      writer.write(std::span(stereo).first(2 * 7));
      writer.write(std::span(stereo).subspan(2 * 7));
      writer.finish();
    }
    EXPECT_EQ(bytes_of(folder / name), bytes_of(folder / (std::string("again") + name)));
    AudioFile file(folder / name, rate);
    const auto found = read(file, 0, 10001);
    const float tolerance = std::string(name) == "a.wav" ? 0.0F : 0x1p-23F;
    for (std::size_t i = 0; i < stereo.size(); ++i) ASSERT_NEAR(found[i], stereo[i], tolerance) << name << i;
    EXPECT_EQ(file.seconds(), 10000.0 / rate) << name;
  }
}

TEST(AudioWriter, LeavesNothingUnlessItIsFinished) {
  const ScratchFolder folder;
  { AudioWriter(folder / "a.wav", rate).write(ramp(100000)); }
  EXPECT_TRUE(folder.is_empty());
  EXPECT_THROW(AudioWriter(folder / "a.ogg", rate), Error);
  EXPECT_THROW(AudioWriter(folder / "none/a.wav", rate), Error);
}

}  // namespace
}  // namespace shadertwin::media::audio_test

#include "host/media/video_writer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "host/base/error.h"
#include "tests/flat_image.h"
#include "tests/media/packets.h"
#include "tests/scratch_folder.h"

namespace shadertwin::media {
namespace {

void write(const std::filesystem::path& file, const VideoSettings& settings, int frames) {
  const auto writer = VideoWriter::create(file, settings);
  for (int i = 0; i < frames; ++i)
    writer->add(flat_image(settings.width, settings.height, static_cast<float>(i % 7) / 7.0F, 0.5F, 0.25F));
  writer->finish();
  EXPECT_TRUE(writer->warnings().empty());
}

std::string refusal(const std::string& name, const VideoSettings& settings, ExitStatus status) {
  const ScratchFolder folder;
  try {
    VideoWriter::create(folder / name, settings);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), status) << error.what();
    EXPECT_TRUE(folder.is_empty());
    return error.what();
  }
  ADD_FAILURE() << name << " was accepted";
  return "";
}

TEST(VideoWriter, EveryPictureIsOneFrameAtItsTime) {
  const ScratchFolder folder;
  constexpr int frames = 41;
  for (const char* name : {"a.mp4", "a.webm"})
    for (const double fps : {60.0, 29.97, 24.0, 0.5}) {
      write(folder / name, {.width = 32, .height = 16, .fps = fps}, frames);
      const Packets packets = read_packets(folder / name);
      ASSERT_EQ(packets.times.size(), std::size_t{frames}) << name << " at " << fps;
      const double tolerance = std::string(name) == "a.webm" ? 0.0005001 : 1e-9;
      int i = 0;
      for (const auto& [start, duration] : packets.times) EXPECT_NEAR(start, i++ / fps, tolerance) << name;
      const double end = packets.times.rbegin()->first + packets.times.rbegin()->second;
      EXPECT_NEAR(end, frames / fps, 2 * tolerance) << name << " at " << fps;
    }
}

TEST(VideoWriter, FramesOfAGifKeepTheirTimesToTheHundredth) {
  const ScratchFolder folder;
  for (const double fps : {50.0, 30.0, 7.0}) {
    constexpr int frames = 8;
    write(folder / "a.gif", {.width = 17, .height = 9, .fps = fps}, frames);
    const Packets packets = read_packets(folder / "a.gif");
    ASSERT_EQ(packets.times.size(), std::size_t{frames}) << fps;
    int i = 0;
    for (const auto& [start, duration] : packets.times) {
      EXPECT_NEAR(start, std::round(100.0 * i / fps) / 100.0, 1e-9) << fps;
      ++i;
      EXPECT_NEAR(start + duration, std::round(100.0 * i / fps) / 100.0, 1e-9) << fps;
    }
  }
}

TEST(VideoWriter, SaysWhichColoursItHolds) {
  const ScratchFolder folder;
  for (const char* name : {"a.mp4", "a.webm"}) {
    write(folder / name, {.width = 32, .height = 16}, 3);
    const Packets packets = read_packets(folder / name);
    const AVCodecParameters& codec = packets.codec(AVMEDIA_TYPE_VIDEO);
    EXPECT_EQ(codec.color_range, AVCOL_RANGE_MPEG) << name;
    EXPECT_EQ(codec.color_space, AVCOL_SPC_BT709) << name;
    EXPECT_EQ(codec.color_primaries, AVCOL_PRI_BT709) << name;
    EXPECT_EQ(codec.color_trc, AVCOL_TRC_BT709) << name;
  }
}

// Half a second of a sine of 0.06 a sample. Both codecs change its bits, but neither its pitch nor where it
// is.
TEST(VideoWriter, SoundIsWhatWasWrittenAndAsLongAsItsSamples) {
  const ScratchFolder folder;
  for (const char* name : {"a.mp4", "a.webm"}) {
    constexpr int frames = 31;
    constexpr int per_frame = 44100 / 60;
    const auto writer = VideoWriter::create(folder / name, {.width = 16, .height = 16, .sample_rate = 44100});
    std::vector<float> samples(2 * per_frame);
    for (int i = 0; i < frames; ++i) {
      for (int s = 0; s < per_frame; ++s)
        samples[2 * s] = samples[2 * s + 1] = std::sin(0.06F * static_cast<float>(i * per_frame + s));
      writer->add(flat_image(16, 16, 0, 0, 0));
      writer->add_sound(samples);
    }
    writer->finish();
    const Sound sound = decode_sound(folder / name);
    const std::int64_t expected = std::int64_t{frames} * sound.rate / 60;
    if (std::string(name) == "a.mp4") {
      EXPECT_EQ(sound.rate, 44100);
      EXPECT_EQ(sound.stated, expected);  // libav itself plays the last AAC frame to its end
    } else {
      EXPECT_EQ(sound.rate, 48000);
      EXPECT_EQ(sound.samples, expected);
    }
    ASSERT_GE(sound.left.size(), static_cast<std::size_t>(expected)) << name;
    double error = 0.0;
    // A codec may round off the ends, where the sine begins and breaks off. What two samples too early or
    // late make is 0.08, another pitch 1; AAC makes 0.035 here.
    const auto first = expected / 10;
    const auto last = expected - first;
    for (auto i = first; i < last; ++i) {
      const double at = static_cast<double>(i) * 44100.0 / sound.rate;
      error += std::pow(sound.left[static_cast<std::size_t>(i)] - std::sin(0.06 * at), 2.0);
    }
    EXPECT_LT(std::sqrt(error / static_cast<double>(last - first)), 0.05) << name;
  }
}

TEST(VideoWriter, SamePicturesGiveTheSameFile) {
  const ScratchFolder folder;
  const auto bytes = [&](const std::string& name) {
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  for (const std::string extension : {".mp4", ".webm", ".gif"}) {
    write(folder / ("a" + extension), {.width = 32, .height = 16, .fps = 25.0}, 5);
    write(folder / ("b" + extension), {.width = 32, .height = 16, .fps = 25.0}, 5);
    EXPECT_EQ(bytes("a" + extension), bytes("b" + extension)) << extension;
  }
}

TEST(VideoWriter, RefusesWhatAFormatCannotHave) {
  EXPECT_NE(refusal("a.mp4", {.width = 33, .height = 16}, ExitStatus::usage).find("even"), std::string::npos);
  EXPECT_NE(refusal("a.gif", {.width = 32, .height = 16, .fps = 60.0}, ExitStatus::usage).find("50"),
            std::string::npos);
  EXPECT_NE(refusal("a.webm", {.width = 32, .height = 16, .crf = 64}, ExitStatus::usage).find("63"),
            std::string::npos);
  EXPECT_NE(
      refusal("a.gif", {.width = 32, .height = 16, .fps = 25.0, .crf = 4}, ExitStatus::usage).find("--crf"),
      std::string::npos);
  EXPECT_NE(refusal("a.avi", {.width = 32, .height = 16}, ExitStatus::usage).find(".webm"),
            std::string::npos);
  EXPECT_NE(refusal("a.mp4", {.width = 20000, .height = 16}, ExitStatus::usage).find("16384"),
            std::string::npos);
  EXPECT_NE(refusal("none/a.mp4", {.width = 32, .height = 16}, ExitStatus::file).find("none"),
            std::string::npos);
}

TEST(VideoWriter, NamesAnEncoderThatIsMissingOrStandsIn) {
  EXPECT_NE(refusal("a.mp4", {.width = 32, .height = 16, .encoders = {"absent"}}, ExitStatus::device)
                .find("absent"),
            std::string::npos);
  const ScratchFolder folder;
  const auto writer =
      VideoWriter::create(folder / "a.mp4", {.width = 32, .height = 16, .encoders = {"absent", "mpeg4"}});
  ASSERT_EQ(writer->warnings().size(), 1U);
  EXPECT_NE(writer->warnings()[0].find("mpeg4 stands in"), std::string::npos) << writer->warnings()[0];
  for (int i = 0; i < 3; ++i) writer->add(flat_image(32, 16, 1, 0, 0));
  writer->finish();
  EXPECT_EQ(read_packets(folder / "a.mp4").times.size(), 3U);
}

TEST(VideoWriter, AnUnfinishedVideoLeavesTheOldFile) {
  const ScratchFolder folder;
  folder.write("a.webm", "old");
  {
    const auto writer = VideoWriter::create(folder / "a.webm", {.width = 32, .height = 16});
    writer->add(flat_image(32, 16, 1, 0, 0));
  }
  EXPECT_EQ(std::filesystem::file_size(folder / "a.webm"), 3U);
  std::filesystem::remove(folder / "a.webm");
  EXPECT_TRUE(folder.is_empty());
}

}  // namespace
}  // namespace shadertwin::media

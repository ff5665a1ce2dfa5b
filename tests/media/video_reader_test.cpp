#include "host/media/video_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "host/base/error.h"
#include "host/media/muxer.h"
#include "host/media/video_writer.h"
#include "tests/media/packets.h"
#include "tests/scratch_folder.h"

namespace shadertwin::media {
namespace {

using Color = std::array<int, 3>;

// The lower half in one colour, the upper half in another.
Image halves(int width, int height, Color below, Color above) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Color& color = y < height / 2 ? below : above;
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(color[c]) / 255.0F;
      image.at(x, y)[3] = 1.0F;
    }
  return image;
}

Color frame_color(int frame) {
  return {40 + 7 * (frame % 25), 220 - 5 * (frame % 31), 30 + 11 * (frame % 17)};
}

void write_video(const std::filesystem::path& file, int frames, VideoSettings settings) {
  const auto writer = VideoWriter::create(file, settings);
  for (int i = 0; i < frames; ++i)
    writer->add(halves(settings.width, settings.height, frame_color(i), {0, 0, 0}));
  writer->finish();
}

Color texel(const Texture& texture, int x, int y) {
  const std::size_t at = std::size_t{4} * (static_cast<std::size_t>(y) * texture.width + x);
  return {std::to_integer<int>(texture.data[at]), std::to_integer<int>(texture.data[at + 1]),
          std::to_integer<int>(texture.data[at + 2])};
}

int distance(const Color& a, const Color& b) {
  int worst = 0;
  for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
  return worst;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// One level of 219 is 1.16 of 255; the matrix adds its own rounding.
constexpr int rounding = 3;

TEST(VideoReader, ColoursComeBackAsTheyWereWritten) {
  const ScratchFolder folder;
  constexpr std::array<Color, 10> colors = {{{255, 255, 255},
                                             {0, 0, 0},
                                             {255, 0, 0},
                                             {0, 255, 0},
                                             {0, 0, 255},
                                             {128, 128, 128},
                                             {255, 255, 0},
                                             {0, 128, 255},
                                             {20, 40, 60},
                                             {250, 128, 114}}};
  for (const char* name : {"a.mp4", "a.webm"})
    for (const bool full_chroma : {false, true}) {
      VideoSettings settings{.width = 32, .height = 32, .fps = 10.0, .crf = 0, .full_chroma = full_chroma};
      const auto writer = VideoWriter::create(folder / name, settings);
      for (const Color& color : colors) writer->add(halves(32, 32, color, color));
      writer->finish();
      VideoReader reader(folder / name, true);
      for (std::size_t i = 0; i < colors.size(); ++i) {
        reader.show(0.1 * static_cast<double>(i));
        EXPECT_LE(distance(texel(reader.picture(), 11, 13), colors[i]), rounding)
            << name << (full_chroma ? " 4:4:4" : " 4:2:0") << ", colour " << i << ": "
            << testing::PrintToString(texel(reader.picture(), 11, 13));
      }
    }
}

TEST(VideoReader, AMomentHasTheSamePictureHoweverItIsReached) {
  const ScratchFolder folder;
  constexpr int frames = 40;
  for (const char* name : {"a.mp4", "a.webm"}) {
    write_video(folder / name, frames, {.width = 16, .height = 16, .fps = 60.0, .crf = 4});
    VideoReader forward(folder / name, true);
    std::vector<std::vector<std::byte>> pictures;
    for (int i = 0; i < frames; ++i) {
      EXPECT_EQ(forward.show(i / 60.0), i > 0) << name << ", frame " << i;
      EXPECT_LE(distance(texel(forward.picture(), 8, 4), frame_color(i)), 2 * rounding)
          << name << ", frame " << i;
      pictures.push_back(forward.picture().data);
    }
    VideoReader jumping(folder / name, true);
    for (const int i : {39, 3, 4, 2, 38, 0, 39, 20, 20, 1}) {
      jumping.show(i / 60.0);
      EXPECT_EQ(jumping.picture().data, pictures[static_cast<std::size_t>(i)]) << name << ", frame " << i;
    }
  }
}

TEST(VideoReader, RepeatsFromItsEnd) {
  const ScratchFolder folder;
  write_video(folder / "a.mp4", 7, {.width = 16, .height = 16, .fps = 30.0});
  VideoReader reader(folder / "a.mp4", true);
  EXPECT_NEAR(reader.duration(), 7 / 30.0, 1e-9);
  for (int i = 0; i < 40; ++i) {
    reader.show(i / 30.0);
    EXPECT_LE(distance(texel(reader.picture(), 8, 4), frame_color(i % 7)), 2 * rounding) << i;
    EXPECT_NEAR(reader.position(), (i % 7) / 30.0, 1e-6) << i;
  }
  reader.show(-1 / 30.0);
  EXPECT_LE(distance(texel(reader.picture(), 8, 4), frame_color(6)), 2 * rounding);
}

TEST(VideoReader, PutsTheBottomRowFirstOnlyIfAsked) {
  const ScratchFolder folder;
  write_video(folder / "a.webm", 2, {.width = 18, .height = 15});
  const VideoReader flipped(folder / "a.webm", true);
  const VideoReader upright(folder / "a.webm", false);
  EXPECT_EQ(flipped.picture().width, 18);
  EXPECT_EQ(flipped.picture().height, 15);
  EXPECT_LE(distance(texel(flipped.picture(), 9, 1), frame_color(0)), 2 * rounding);
  EXPECT_EQ(texel(flipped.picture(), 9, 1), texel(upright.picture(), 9, 13));
  EXPECT_LE(distance(texel(upright.picture(), 9, 1), {0, 0, 0}), 2 * rounding);
}

TEST(VideoReader, AFileThatBreaksOffIsRepeatedFromThere) {
  const ScratchFolder folder;
  write_video(folder / "whole.mp4", 120, {.width = 32, .height = 32, .fps = 30.0, .crf = 1});
  const std::string bytes = bytes_of(folder / "whole.mp4");
  folder.write("cut.mp4", bytes.substr(0, bytes.size() * 2 / 3));
  VideoReader reader(folder / "cut.mp4", true);
  EXPECT_LT(reader.duration(), 3.7);
  EXPECT_GT(reader.duration(), 0.5);
  EXPECT_NE(reader.warning().find("of its 4.00 seconds"), std::string::npos) << reader.warning();
  for (const double t : {0.0, 3.9, 1.0}) {
    reader.show(t);
    const int frame = static_cast<int>(std::lround(std::fmod(t, reader.duration()) * 30.0 - 0.49));
    EXPECT_LE(distance(texel(reader.picture(), 16, 8), frame_color(frame)), 2 * rounding)
        << t << " s, frame " << frame << " of " << reader.duration() * 30.0;
  }
}

TEST(VideoReader, PicturesOfAnotherSizeAreScaledToTheFirst) {
  const ScratchFolder folder;
  write_video(folder / "a.webm", 3, {.width = 32, .height = 16, .fps = 10.0});
  write_video(folder / "b.webm", 3, {.width = 64, .height = 48, .fps = 10.0});
  {
    Muxer muxer(folder / "both.webm", "both.webm");
    const InputFormat a = open_input(folder / "a.webm");
    AVStream* const stream = avformat_new_stream(&muxer.context(), nullptr);
    avcodec_parameters_copy(stream->codecpar, a->streams[0]->codecpar);
    stream->time_base = a->streams[0]->time_base;
    muxer.begin();
    const PacketPointer packet = make_packet();
    std::int64_t shift = 0;
    for (const char* name : {"a.webm", "b.webm"}) {
      const InputFormat input = open_input(folder / name);
      while (av_read_frame(input.get(), packet.get()) >= 0) {
        packet->pts += shift;
        packet->dts += shift;
        muxer.write(*packet);
      }
      shift = 300;
    }
    muxer.end();
  }
  VideoReader reader(folder / "both.webm", true);
  for (int i = 0; i < 6; ++i) {
    reader.show(0.1 * i);
    EXPECT_EQ(reader.picture().width, 32);
    EXPECT_EQ(reader.picture().height, 16);
    EXPECT_LE(distance(texel(reader.picture(), 16, 3), frame_color(i % 3)), 2 * rounding) << i;
  }
}

TEST(VideoReader, RefusesWhatIsNoVideoInOneLine) {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& name) -> std::string {
    try {
      VideoReader(folder / name, true);
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::file);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("none.mp4").find("none.mp4"), std::string::npos);
  folder.write("empty.mp4", "");
  EXPECT_NE(refusal("empty.mp4").find("empty"), std::string::npos);
  folder.write("text.mp4", "this is no video at all");
  EXPECT_NE(refusal("text.mp4").find("text.mp4"), std::string::npos);
  ASSERT_EQ(mkfifo((folder / "pipe.mp4").c_str(), 0600), 0);
  EXPECT_NE(refusal("pipe.mp4").find("plain file"), std::string::npos);
  folder.write("list.mp4", "#EXTM3U\n#EXT-X-TARGETDURATION:10\n#EXTINF:9,\n/etc/passwd\n");
  EXPECT_NE(refusal("list.mp4").find("list.mp4"), std::string::npos);
  write_video(folder / "whole.mp4", 5, {.width = 32, .height = 32});
  const std::string bytes = bytes_of(folder / "whole.mp4");
  folder.write("head.mp4", bytes.substr(0, bytes.find("mdat") + 8));
  EXPECT_NE(refusal("head.mp4").find("head.mp4"), std::string::npos);
}

}  // namespace
}  // namespace shadertwin::media

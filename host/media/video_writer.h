// Pictures, one after the other, into a video file.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/base/output_format.h"
#include "host/image/image.h"

namespace shadertwin::media {

struct VideoSettings {
  int width = 0;  // of every picture
  int height = 0;
  double fps = 60.0;
  // Constant rate factor: 0 (lossless) to 51 for .mp4, to 63 for .webm. Below 0: 18 for .mp4, 24 for .webm.
  int crf = -1;
  bool full_chroma = false;  // 4:4:4 instead of 4:2:0
  int sample_rate = 0;       // of the sound, in stereo; 0: there is none
  // libav's names of the encoders to try, in this order; empty: those of the format.
  std::vector<std::string> encoders = {};
};

std::vector<OutputFormat> video_formats();

// What VideoSettings::crf may be, format by format, for people.
std::string crf_help();

// Whether the extension is one of a video: .mp4 (H.264 and AAC), .webm (VP9 and Opus) or .gif.
bool is_video(const std::filesystem::path& file);

// The highest rate, in frames a second, that every program plays as written. A GIF counts in hundredths of a
// second, and browsers take a frame of one hundredth for a tenth.
double highest_rate(const std::filesystem::path& file);

// Frame i is shown from i / fps on (in .webm to the nearest millisecond, in .gif to the nearest hundredth),
// and the last one as long as the others. Colours are what a browser's canvas shows, clamped to 8 bits; H.264
// and VP9 get them as BT.709 in limited range and say so. Memory does not grow with the number of pictures.
// The file appears when it is finished, and not at all before.
class VideoWriter {
 public:
  // Throws Error(usage) for settings that the format can't have, Error(device) if this machine has no encoder
  // for it, and Error(file) if the file can't be written.
  static std::unique_ptr<VideoWriter> create(const std::filesystem::path& file,
                                             const VideoSettings& settings);
  virtual ~VideoWriter() = default;

  // add(), add_sound() and finish() throw Error(file).
  virtual void add(const Image& picture) = 0;
  // Samples left, right, left ... in [-1, 1]. Give each frame's after its picture, so that none has to wait.
  virtual void add_sound(std::span<const float> samples) = 0;
  // Whether there is a track for it: asked for, and not a GIF.
  virtual bool has_sound() const = 0;
  virtual void finish() = 0;

  // Lines for people: an encoder that had to stand in for a better one.
  virtual const std::vector<std::string>& warnings() const = 0;
};

}  // namespace shadertwin::media

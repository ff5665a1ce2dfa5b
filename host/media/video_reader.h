// A video file as a browser plays it in a loop.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/media/libav.h"
#include "host/media/video_picture.h"

namespace shadertwin::media {

// Shows, for a moment, the picture whose time has come last, whatever was shown before: the same moment
// always has the same picture. A file lasts as long as the longest of its streams, by what is really in it.
// Pictures of another size than the first are scaled to it.
class VideoReader {
 public:
  // `flip` puts the bottom row at t = 0. Throws Error(file) for what is no video, or has no picture that can
  // be decoded. The first picture is shown.
  VideoReader(std::filesystem::path file, bool flip);

  // Shows the picture of a moment, in seconds of looping playback; whether it is another one than before.
  bool show(double seconds);
  const Texture& picture() const { return converter_.picture(); }
  double duration() const { return duration_; }  // of one round, seconds
  double position() const { return position_; }  // of the last show(), within a round
  // What the user should know: the file ends before it says. Empty otherwise.
  const std::string& warning() const { return warning_; }

 private:
  void index();
  void measure(double end, double stated);
  void open();
  void start_at(std::int64_t keyframe);
  bool decode_next();
  void decode_to(std::int64_t wanted);

  std::filesystem::path file_;
  VideoConverter converter_;
  InputFormat input_;
  CodecContext decoder_;
  int stream_ = -1;
  std::vector<std::int64_t> times_;      // of every picture, in the order of showing, in the stream's unit
  std::vector<std::int64_t> keyframes_;  // of those that can be decoded by themselves
  std::int64_t last_duration_ = 0;       // of the last picture, as its packet says
  double unit_ = 0.0;                    // seconds
  double duration_ = 0.0;
  double position_ = 0.0;
  std::string warning_;
  bool seekable_ = true;

  PacketPointer packet_ = make_packet();
  FramePointer shown_ = make_frame();  // of which picture() was made
  FramePointer ahead_ = make_frame();  // decoded, but not due yet; empty if there is none
  bool drained_ = false;
};

}  // namespace shadertwin::media

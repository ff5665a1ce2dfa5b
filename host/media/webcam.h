// The machine's camera.
#pragma once

#include <memory>
#include <string>

#include "host/media/video_picture.h"

namespace shadertwin::media {

class Webcam {
 public:
  // The first /dev/videoN that gives pictures, and the first of them. Null if there is none: `problem` says
  // why, in half a line. `flip` puts the bottom row at t = 0.
  static std::unique_ptr<Webcam> open(bool flip, std::string& problem);

  // Takes the newest picture without waiting for one; whether there was one.
  bool update();
  const Texture& picture() const { return converter_.picture(); }

 private:
  Webcam(InputFormat input, bool flip);

  InputFormat input_;
  CodecContext decoder_;
  VideoConverter converter_;
  PacketPointer packet_ = make_packet();
  FramePointer decoded_ = make_frame();
  FramePointer newest_ = make_frame();
};

}  // namespace shadertwin::media

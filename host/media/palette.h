// Pictures in the 256 colours of a GIF.
#pragma once

#include "host/image/image.h"
#include "host/media/libav.h"

struct AVFilterGraph;
struct AVFilterContext;

namespace shadertwin::media {

// Every picture gets a palette of its own, chosen for it, so that none has to wait for the last one.
class Palette {
 public:
  // Throws Error(device) if libav lacks the filters.
  Palette(int width, int height);
  ~Palette();
  Palette(const Palette&) = delete;
  Palette& operator=(const Palette&) = delete;

  // A frame of AV_PIX_FMT_PAL8, valid until the next call. Throws std::bad_alloc.
  const AVFrame& convert(const Image& picture);

 private:
  AVFilterGraph* graph_ = nullptr;
  AVFilterContext* source_ = nullptr;
  AVFilterContext* sink_ = nullptr;
  FramePointer result_ = make_frame();
  std::int64_t frames_ = 0;
};

}  // namespace shadertwin::media

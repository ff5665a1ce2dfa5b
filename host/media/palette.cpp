#include "host/media/palette.h"

extern "C" {
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
}

#include <new>
#include <string>

#include "host/base/error.h"
#include "host/media/picture_converter.h"

namespace shadertwin::media {

namespace {

// An ordered dither: unlike diffusion it does not crawl where a picture stands still, and compresses better.
constexpr const char* filters =
    "split[a][b];[a]palettegen=stats_mode=single:reserve_transparent=0[p];"
    "[b][p]paletteuse=new=1:dither=bayer:bayer_scale=4";

void check(int code) {
  if (code < 0)
    throw Error(ExitStatus::device, "libav can't choose the colours of a GIF here: " + words_for(code));
}

}  // namespace

Palette::Palette(int width, int height) : graph_(avfilter_graph_alloc()) {
  if (graph_ == nullptr) throw std::bad_alloc();
  graph_->nb_threads = 1;
  const std::string description = "buffer=video_size=" + std::to_string(width) + "x" +
                                  std::to_string(height) + ":pix_fmt=rgb0:time_base=1/1:pixel_aspect=1/1," +
                                  filters + ",buffersink";
  AVFilterInOut* inputs = nullptr;
  AVFilterInOut* outputs = nullptr;
  try {
    check(avfilter_graph_parse2(graph_, description.c_str(), &inputs, &outputs));
    check(avfilter_graph_config(graph_, nullptr));
  } catch (...) {
    avfilter_graph_free(&graph_);
    throw;
  }
  for (unsigned i = 0; i < graph_->nb_filters; ++i) {
    const std::string name = graph_->filters[i]->filter->name;
    if (name == "buffer") source_ = graph_->filters[i];
    if (name == "buffersink") sink_ = graph_->filters[i];
  }
}

Palette::~Palette() {
  avfilter_graph_free(&graph_);
}

const AVFrame& Palette::convert(const Image& picture) {
  FramePointer rgb = make_picture_frame(AV_PIX_FMT_RGB0, picture.width, picture.height);
  fill_rgb(picture, *rgb);
  rgb->pts = frames_++;
  check(av_buffersrc_add_frame(source_, rgb.get()));
  av_frame_unref(result_.get());
  check(av_buffersink_get_frame(sink_, result_.get()));
  return *result_;
}

}  // namespace shadertwin::media

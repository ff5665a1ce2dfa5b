// What every user of libav here shares: owners of its objects, its headers, and its errors in words.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/avutil.h>
#include <libswresample/swresample.h>
#include <libswscale/swscale.h>
}

#include "host/base/error.h"

namespace shadertwin::media {

// Frees a libav object through the function of its kind, which takes the address of a pointer.
template <auto free>
struct FreeAt {
  template <class T>
  void operator()(T* object) const {
    free(&object);
  }
};
using CodecContext = std::unique_ptr<AVCodecContext, FreeAt<avcodec_free_context>>;
using FramePointer = std::unique_ptr<AVFrame, FreeAt<av_frame_free>>;
using PacketPointer = std::unique_ptr<AVPacket, FreeAt<av_packet_free>>;
using Resampler = std::unique_ptr<SwrContext, FreeAt<swr_free>>;
struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
using Scaler = std::unique_ptr<SwsContext, FreeScaler>;
using InputFormat = std::unique_ptr<AVFormatContext, FreeAt<avformat_close_input>>;

// Both throw std::bad_alloc.
FramePointer make_frame();
PacketPointer make_packet();

// libav's own words for one of its negative return values.
std::string words_for(int error);

// libav prints to stderr by default; what matters is told by exceptions. Called by everything here that uses
// it.
void silence_libav();

// Opens a file for reading and finds its streams. Only plain files are opened: a playlist can't lead anywhere
// else. Throws Error(file).
InputFormat open_input(const std::filesystem::path& file);

// The codec of a stream, ready to decode with that many threads. Throws Error(file), naming `file`.
CodecContext open_decoder(const AVStream& stream, const std::filesystem::path& file, int threads = 1);

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& message);

// Throws Error(file) for a negative value.
inline int check(int result, const std::filesystem::path& file) {
  if (result < 0) fail(file, words_for(result));
  return result;
}

}  // namespace shadertwin::media

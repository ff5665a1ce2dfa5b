// A file of encoded streams that is being written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "host/media/libav.h"

namespace shadertwin::media {

// Streams are added, then begin(), packets, end(). Every function throws Error(file) with the name of the
// file that the user knows.
class Muxer {
 public:
  // `file` is written, in the format of its extension; `shown` is its name in messages.
  Muxer(const std::filesystem::path& file, std::string shown);
  ~Muxer();
  Muxer(const Muxer&) = delete;
  Muxer& operator=(const Muxer&) = delete;

  AVFormatContext& context() { return *context_; }
  // A stream of what `codec` encodes. It lives as long as this.
  AVStream& add_stream(const AVCodecContext& codec);
  void begin();
  // Takes the packet's contents. Packets of all streams are put in the order of time.
  void write(AVPacket& packet);
  void end();

  [[noreturn]] void fail(const std::string& what, int code) const;

 private:
  AVFormatContext* context_ = nullptr;
  std::string shown_;
};

// Encodes one stream into a muxer.
class Encoder {
 public:
  // `configure` sets the codec's fields and options before it is opened. Throws Error(usage) if the codec
  // refuses them.
  Encoder(Muxer& muxer, const AVCodec& codec, const std::function<void(AVCodecContext&)>& configure);

  AVCodecContext& context() { return *codec_; }
  AVStream& stream() { return stream_; }
  // Null ends the stream. `packet_duration`: in the codec's time base, for codecs that don't say it; 0: they
  // do.
  void encode(const AVFrame* frame, std::int64_t packet_duration = 0);

 private:
  CodecContext open(const AVCodec& codec, const std::function<void(AVCodecContext&)>& configure);

  Muxer& muxer_;
  CodecContext codec_;
  AVStream& stream_;
  PacketPointer packet_ = make_packet();
};

}  // namespace shadertwin::media

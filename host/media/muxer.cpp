#include "host/media/muxer.h"

#include <new>

#include "host/base/error.h"

namespace shadertwin::media {

Muxer::Muxer(const std::filesystem::path& file, std::string shown) : shown_(std::move(shown)) {
  silence_libav();
  const std::string url = "file:" + file.string();  // else a colon in its name means a protocol
  int code = avformat_alloc_output_context2(&context_, nullptr, nullptr, url.c_str());
  if (code < 0) fail("this libav can't write such files", code);
  // The same command shall give the same file: no version of a library, no random identifiers.
  context_->flags |= AVFMT_FLAG_BITEXACT;
  code = avio_open(&context_->pb, url.c_str(), AVIO_FLAG_WRITE);
  if (code < 0) {
    avformat_free_context(context_);
    fail("can't be written", code);
  }
}

Muxer::~Muxer() {
  avio_closep(&context_->pb);
  avformat_free_context(context_);
}

void Muxer::fail(const std::string& what, int code) const {
  throw Error(ExitStatus::file, shown_ + ": " + what + ": " + words_for(code));
}

AVStream& Muxer::add_stream(const AVCodecContext& codec) {
  AVStream* const stream = avformat_new_stream(context_, nullptr);
  if (stream == nullptr) throw std::bad_alloc();
  stream->time_base = codec.time_base;
  if (const int code = avcodec_parameters_from_context(stream->codecpar, &codec); code < 0)
    fail("can't be written", code);
  return *stream;
}

void Muxer::begin() {
  if (const int code = avformat_write_header(context_, nullptr); code < 0) fail("can't be written", code);
}

void Muxer::write(AVPacket& packet) {
  int code = av_interleaved_write_frame(context_, &packet);
  if (code >= 0) code = context_->pb->error;
  if (code < 0) fail("can't be written", code);
}

void Muxer::end() {
  int code = av_write_trailer(context_);
  if (code >= 0) code = context_->pb->error;
  const int closed = avio_closep(&context_->pb);
  if (code >= 0) code = closed;
  if (code < 0) fail("can't be written", code);
}

Encoder::Encoder(Muxer& muxer, const AVCodec& codec, const std::function<void(AVCodecContext&)>& configure)
    : muxer_(muxer), codec_(open(codec, configure)), stream_(muxer.add_stream(*codec_)) {}

CodecContext Encoder::open(const AVCodec& codec, const std::function<void(AVCodecContext&)>& configure) {
  CodecContext context(avcodec_alloc_context3(&codec));
  if (!context) throw std::bad_alloc();
  context->flags |= AV_CODEC_FLAG_BITEXACT;
  if (muxer_.context().oformat->flags & AVFMT_GLOBALHEADER) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  configure(*context);
  if (const int code = avcodec_open2(context.get(), &codec, nullptr); code < 0)
    muxer_.fail(std::string("the encoder ") + codec.name + " refuses this", code);
  return context;
}

void Encoder::encode(const AVFrame* frame, std::int64_t packet_duration) {
  int code = avcodec_send_frame(codec_.get(), frame);
  if (code < 0) muxer_.fail("can't be encoded", code);
  while ((code = avcodec_receive_packet(codec_.get(), packet_.get())) >= 0) {
    packet_->stream_index = stream_.index;
    if (packet_duration > 0) packet_->duration = packet_duration;
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_.time_base);
    muxer_.write(*packet_);
  }
  if (code != AVERROR(EAGAIN) && code != AVERROR_EOF) muxer_.fail("can't be encoded", code);
}

}  // namespace shadertwin::media

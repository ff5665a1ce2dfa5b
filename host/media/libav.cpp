#include "host/media/libav.h"

#include <array>
#include <new>

namespace shadertwin::media {

namespace fs = std::filesystem;

FramePointer make_frame() {
  FramePointer frame(av_frame_alloc());
  if (!frame) throw std::bad_alloc();
  return frame;
}

PacketPointer make_packet() {
  PacketPointer packet(av_packet_alloc());
  if (!packet) throw std::bad_alloc();
  return packet;
}

std::string words_for(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

void silence_libav() {
  av_log_set_level(AV_LOG_QUIET);
}

namespace {

// What libav returns for contents that make no sense to it, whatever the words for the code are.
bool is_damage(int code) {
  return code == AVERROR_INVALIDDATA || code == AVERROR(EINVAL) || code == AVERROR(EPERM) ||
         code == AVERROR_EOF;
}

}  // namespace

void fail(const fs::path& file, const std::string& message) {
  throw Error(ExitStatus::file, file.generic_string() + ": " + message);
}

InputFormat open_input(const fs::path& file) {
  silence_libav();
  std::error_code problem;
  if (!fs::exists(file, problem)) fail(file, problem ? problem.message() : "No such file or directory");
  if (fs::is_directory(file, problem)) fail(file, "is a folder");
  // A pipe would be waited for, and can't be read from its middle.
  if (!fs::is_regular_file(file, problem)) fail(file, "is not a plain file");
  if (fs::file_size(file, problem) == 0) fail(file, "the file is empty");
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  av_dict_set(
      &options, "format_whitelist",
      "wav,w64,aiff,au,caf,mp3,aac,flac,ogg,mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,mpeg,mpegts,gif", 0);
  AVFormatContext* context = nullptr;
  const int opened = avformat_open_input(&context, ("file:" + file.string()).c_str(), nullptr, &options);
  av_dict_free(&options);
  InputFormat input(context);
  if (opened == AVERROR_EOF) fail(file, "it breaks off before anything can be played");
  if (is_damage(opened)) fail(file, "is neither sound nor a moving picture that can be read");
  check(opened, file);
  if (avformat_find_stream_info(input.get(), nullptr) < 0 || input->nb_streams == 0)
    fail(file, "has nothing in it that can be played");
  return input;
}

CodecContext open_decoder(const AVStream& stream, const fs::path& file, int threads) {
  const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
  if (codec == nullptr) fail(file, "there is no decoder for what is in it");
  CodecContext context(avcodec_alloc_context3(codec));
  if (context == nullptr) throw std::bad_alloc();
  check(avcodec_parameters_to_context(context.get(), stream.codecpar), file);
  context->pkt_timebase = stream.time_base;
  context->thread_count = threads;
  const int decodes = avcodec_open2(context.get(), codec, nullptr);
  if (is_damage(decodes)) fail(file, "what is in it can't be decoded");
  check(decodes, file);
  return context;
}

}  // namespace shadertwin::media

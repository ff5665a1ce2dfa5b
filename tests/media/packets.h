// What is in a media file, by its packets.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "host/media/libav.h"

namespace shadertwin::media {

struct Packets {
  InputFormat input;
  std::map<double, double> times;  // of the first stream of a kind: start -> duration, seconds

  const AVCodecParameters& codec(AVMediaType kind) const {
    return *input->streams[av_find_best_stream(input.get(), kind, -1, -1, nullptr, 0)]->codecpar;
  }
};

// The packets of the first video (or audio) stream in the order in which they are shown.
inline Packets read_packets(const std::filesystem::path& file, AVMediaType kind = AVMEDIA_TYPE_VIDEO) {
  Packets packets{open_input(file), {}};
  const int stream = av_find_best_stream(packets.input.get(), kind, -1, -1, nullptr, 0);
  if (stream < 0) return packets;
  const double tick = av_q2d(packets.input->streams[stream]->time_base);
  const PacketPointer packet = make_packet();
  while (av_read_frame(packets.input.get(), packet.get()) >= 0) {
    if (packet->stream_index == stream)
      packets.times[static_cast<double>(packet->pts) * tick] = static_cast<double>(packet->duration) * tick;
    av_packet_unref(packet.get());
  }
  return packets;
}

struct Sound {
  std::int64_t samples = 0;  // of one channel, as the first audio stream decodes
  std::int64_t stated = 0;   // by the container
  int rate = 0;
  std::vector<float> left;  // the first channel; empty unless it decodes to planes of floats
};
inline Sound decode_sound(const std::filesystem::path& file) {
  const InputFormat input = open_input(file);
  const int index = av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
  const CodecContext codec = open_decoder(*input->streams[index], file);
  const PacketPointer packet = make_packet();
  const FramePointer frame = make_frame();
  const AVStream& stream = *input->streams[index];
  Sound sound{
      0, av_rescale_q(stream.duration, stream.time_base, {1, codec->sample_rate}), codec->sample_rate, {}};
  bool more = true;
  while (more) {
    more = av_read_frame(input.get(), packet.get()) >= 0;
    if (!more || packet->stream_index == index)
      avcodec_send_packet(codec.get(), more ? packet.get() : nullptr);
    av_packet_unref(packet.get());
    while (avcodec_receive_frame(codec.get(), frame.get()) >= 0) {
      sound.samples += frame->nb_samples;
      if (frame->format != AV_SAMPLE_FMT_FLTP) continue;
      const auto* plane = reinterpret_cast<const float*>(frame->data[0]);
      sound.left.insert(sound.left.end(), plane, plane + frame->nb_samples);
    }
  }
  return sound;
}

}  // namespace shadertwin::media

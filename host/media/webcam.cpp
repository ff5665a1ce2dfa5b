#include "host/media/webcam.h"

#include <dlfcn.h>

#include <chrono>
#include <thread>

namespace shadertwin::media {

namespace fs = std::filesystem;

namespace {

constexpr int most_devices = 16;
constexpr auto patience = std::chrono::seconds(5);  // with a camera that has to start up

// libavdevice brings window systems and sound servers along, so that only a machine with a camera loads it.
// Its version goes with libavformat's.
const AVInputFormat* find_v4l2() {
  static void* const library =
      dlopen("libavdevice.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return nullptr;
  if (const auto register_all = reinterpret_cast<void (*)()>(dlsym(library, "avdevice_register_all")))
    register_all();
  return av_find_input_format("v4l2");
}

std::string device_name(int number) {
  return "/dev/video" + std::to_string(number);
}

}  // namespace

std::unique_ptr<Webcam> Webcam::open(bool flip, std::string& problem) {
  silence_libav();
  problem = "there is no camera here";
  const AVInputFormat* v4l2 = nullptr;
  for (int i = 0; i < most_devices; ++i) {
    const std::string device = device_name(i);
    std::error_code ignored;
    if (!fs::exists(device, ignored)) continue;
    if (v4l2 == nullptr) v4l2 = find_v4l2();
    if (v4l2 == nullptr) {
      problem = device + " can't be opened without libavdevice (apt install libavdevice59)";
      return nullptr;
    }
    AVFormatContext* context = avformat_alloc_context();
    if (context == nullptr) throw std::bad_alloc();
    context->flags |= AVFMT_FLAG_NONBLOCK;
    const int code = avformat_open_input(&context, device.c_str(), v4l2, nullptr);
    if (code < 0) {
      problem = device + ": " + words_for(code);
      continue;
    }
    InputFormat input(context);
    if (input->nb_streams == 0) continue;
    try {
      std::unique_ptr<Webcam> webcam(new Webcam(std::move(input), flip));
      const auto start = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - start < patience) {
        if (webcam->update()) return webcam;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
      problem = device + ": gives no picture";
    } catch (const Error& error) {
      problem = error.what();
    }
  }
  return nullptr;
}

Webcam::Webcam(InputFormat input, bool flip)
    : input_(std::move(input)), decoder_(open_decoder(*input_->streams[0], input_->url)), converter_(flip) {
  converter_.set_stream(*input_, *input_->streams[0], input_->url);
}

bool Webcam::update() {
  bool fresh = false;
  while (av_read_frame(input_.get(), packet_.get()) >= 0) {
    avcodec_send_packet(decoder_.get(), packet_.get());
    av_packet_unref(packet_.get());
    while (avcodec_receive_frame(decoder_.get(), decoded_.get()) >= 0) {
      av_frame_unref(newest_.get());
      av_frame_move_ref(newest_.get(), decoded_.get());
      fresh = true;
    }
  }
  if (fresh) converter_.convert(*newest_);
  return fresh;
}

}  // namespace shadertwin::media

#include "host/media/microphone.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "host/media/alsa.h"

namespace shadertwin::media {

struct Microphone::State {
  AlsaDevice device;
  std::vector<float> heard;
  std::size_t most = 0;  // samples that one call takes in: a device of a file's has no end
};

std::unique_ptr<Microphone> Microphone::open(int rate, std::string& why) {
  auto state = std::make_unique<State>();
  constexpr unsigned latency = 50'000;  // microseconds
  int code = open_alsa(state->device, SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK, 1, rate, latency);
  if (code >= 0) code = snd_pcm_start(state->device.get());
  if (code < 0) {
    why = snd_strerror(code);
    return nullptr;
  }
  state->most = static_cast<std::size_t>(rate);
  return std::unique_ptr<Microphone>(new Microphone(std::move(state)));
}

Microphone::Microphone(std::unique_ptr<State> state) : state_(std::move(state)) {}

Microphone::~Microphone() = default;

void Microphone::listen(std::span<float> newest) {
  std::vector<float>& heard = state_->heard;
  snd_pcm_t* device = state_->device.get();
  std::vector<float> piece(1024);
  for (std::size_t taken = 0; taken < state_->most;) {
    const snd_pcm_sframes_t got = snd_pcm_readi(device, piece.data(), piece.size());
    if (got == -EAGAIN || got == 0) break;
    // What was lost while nobody listened is lost.
    if (got < 0) {
      if (snd_pcm_recover(device, static_cast<int>(got), 1) >= 0) snd_pcm_start(device);
      break;
    }
    std::transform(piece.begin(), piece.begin() + got, std::back_inserter(heard),
                   [](float value) { return std::isfinite(value) ? value : 0.0F; });
    taken += static_cast<std::size_t>(got);
  }
  if (heard.size() > newest.size())
    heard.erase(heard.begin(), heard.end() - static_cast<std::ptrdiff_t>(newest.size()));
  const std::size_t silent = newest.size() - heard.size();
  std::fill_n(newest.begin(), silent, 0.0F);
  std::copy(heard.begin(), heard.end(), newest.begin() + static_cast<std::ptrdiff_t>(silent));
}

}  // namespace shadertwin::media

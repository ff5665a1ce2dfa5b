#include "host/media/loudspeaker.h"

#include <alsa/asoundlib.h>

#include "host/media/alsa.h"

namespace shadertwin::media {

namespace {

constexpr int patience = 200;  // milliseconds: a device that takes nothing for so long has stopped

}  // namespace

struct Loudspeaker::State {
  AlsaDevice device;
};

std::unique_ptr<Loudspeaker> Loudspeaker::open(int rate, std::string& why) {
  auto state = std::make_unique<State>();
  constexpr unsigned latency = 300'000;  // microseconds that the device can hold
  int code = open_alsa(state->device, SND_PCM_STREAM_PLAYBACK, SND_PCM_NONBLOCK, 2, rate, latency);
  // By itself it would begin only when it is full, and run dry if it began at once.
  snd_pcm_sw_params_t* parameters = nullptr;
  snd_pcm_sw_params_alloca(&parameters);
  if (code >= 0) code = snd_pcm_sw_params_current(state->device.get(), parameters);
  if (code >= 0)
    code = snd_pcm_sw_params_set_start_threshold(state->device.get(), parameters,
                                                 static_cast<snd_pcm_uframes_t>(rate) / 20);
  if (code >= 0) code = snd_pcm_sw_params(state->device.get(), parameters);
  if (code < 0) {
    why = snd_strerror(code);
    return nullptr;
  }
  return std::unique_ptr<Loudspeaker>(new Loudspeaker(std::move(state)));
}

Loudspeaker::Loudspeaker(std::unique_ptr<State> state) : state_(std::move(state)) {}

Loudspeaker::~Loudspeaker() = default;

bool Loudspeaker::play(std::span<const float> stereo) {
  snd_pcm_t* device = state_->device.get();
  const float* next = stereo.data();
  for (auto left = static_cast<snd_pcm_uframes_t>(stereo.size() / 2); left > 0;) {
    const snd_pcm_sframes_t written = snd_pcm_writei(device, next, left);
    if (written == -EAGAIN && snd_pcm_wait(device, patience) > 0) continue;
    if (written < 0) {
      // It ran dry, or its server went away and may come back.
      snd_pcm_recover(device, static_cast<int>(written), 1);
      return false;
    }
    next += 2 * written;
    left -= static_cast<snd_pcm_uframes_t>(written);
  }
  return true;
}

void Loudspeaker::stop() {
  snd_pcm_drop(state_->device.get());
  snd_pcm_prepare(state_->device.get());
}

}  // namespace shadertwin::media

// What the microphone and the loudspeaker share of ALSA.
#pragma once

#include <alsa/asoundlib.h>

#include <memory>

namespace shadertwin::media {

struct CloseAlsaDevice {
  void operator()(snd_pcm_t* device) const { snd_pcm_close(device); }
};
using AlsaDevice = std::unique_ptr<snd_pcm_t, CloseAlsaDevice>;

// Opens the default device for floats. `latency`: microseconds that it can hold. ALSA's negative code if it
// fails.
int open_alsa(AlsaDevice& device, snd_pcm_stream_t direction, int mode, int channels, int rate,
              unsigned latency);

}  // namespace shadertwin::media

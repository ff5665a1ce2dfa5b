#include "host/media/alsa.h"

namespace shadertwin::media {

namespace {

// ALSA tells its troubles on stderr, but for a handler.
void say_nothing(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

int open_alsa(AlsaDevice& device, snd_pcm_stream_t direction, int mode, int channels, int rate,
              unsigned latency) {
  snd_lib_error_set_handler(say_nothing);
  snd_pcm_t* opened = nullptr;
  const int code = snd_pcm_open(&opened, "default", direction, mode);
  if (code < 0) return code;
  device.reset(opened);
  return snd_pcm_set_params(opened, SND_PCM_FORMAT_FLOAT, SND_PCM_ACCESS_RW_INTERLEAVED,
                            static_cast<unsigned>(channels), static_cast<unsigned>(rate), 1, latency);
}

}  // namespace shadertwin::media

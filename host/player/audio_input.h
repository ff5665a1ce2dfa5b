// Music and the microphone as textures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/player/moving_input.h"

namespace shadertwin {

// 512x2 texels: the spectrum in the row at t = 0, the wave in the other. On shadertoy.com in red alone, for
// the extension in grey. Music without a file is silence; all of it is the site's preview signal if the
// project is muted.
std::unique_ptr<MovingInput> open_audio_input(const Project& project, const Input& input,
                                              std::vector<std::string>& warnings);

}  // namespace shadertwin

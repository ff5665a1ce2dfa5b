// `render` into a file of sound.
#pragma once

#include <string>

#include "host/app/options.h"
#include "host/player/sound.h"

namespace shadertwin::app {

// Plays the Sound pass for `seconds` from --time on into a .wav or .flac. Throws Error(usage) if the shader
// has none.
void render_sound(const PlayOptions& options, double seconds, const std::string& output);

// Says on stderr what was not as the shader gave it.
void print_warnings(const Sound& sound, const std::string& output);

}  // namespace shadertwin::app

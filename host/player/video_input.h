// Videos and the webcam as textures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/player/moving_input.h"

namespace shadertwin {

// A video shows, in every frame, the picture that a looping HTML video shows at iTime; nothing else about the
// frame, or the frames before, matters. Null if the input has no file. Throws Error(file).
std::unique_ptr<MovingInput> open_video_input(const Input& input, std::vector<std::string>& warnings);

// What the machine's first camera sees at the moment. Null, with a warning, if there is none.
std::unique_ptr<MovingInput> open_webcam_input(const Input& input, std::vector<std::string>& warnings);

}  // namespace shadertwin

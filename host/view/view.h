// `shadertwin view`: a project in a window, live.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "host/gl/gl_device.h"
#include "host/player/live_clock.h"
#include "host/project/project.h"
#include "host/view/stage.h"

namespace shadertwin::view {

struct ViewOptions {
  std::filesystem::path shader;
  LoadOptions load;
  std::function<void(const Project&)> accept;  // throws if the first project isn't what the options are for
  glm::ivec2 size{640, 360};                   // of the picture at resolution 1, in pixels
  LiveSettings clock;
  double recording_rate = 60.0;  // frames a second of shader time while recording
  std::string pass;              // shown at first; empty: the last one
  gl::PlayerOptions player;      // in the window's own context
  MakePlayer other_player;       // if given, plays instead
  MakePlayer sound_player;       // draws the Sound pass
  std::string output;            // screenshots are OUTPUT_0001.png and .exr; empty: the shader's name
  std::string options_text;      // for commands that repeat a frame: -D and the like, as the user gave them
  bool quiet = false;            // nothing on stderr but errors
};

// Returns when the window is closed. Throws Error for what goes wrong before the first picture: Error(device)
// without a display or OpenGL ES 3, and what loading throws. Later problems are laid over the picture.
void run_view(const ViewOptions& options);

}  // namespace shadertwin::view

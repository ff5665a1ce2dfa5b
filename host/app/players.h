// Players by the name that --on gives them.
#pragma once

#include <memory>
#include <string>

#include "host/gl/gl_player.h"
#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin::app {

// What follows the slash in `on`. Throws Error(usage) if it is neither fragment nor compute.
gl::Dispatch dispatch_of(const std::string& on);

// `on`: auto | egl[:N] | osmesa, then /fragment or /compute if wanted. Prints the player's warnings unless
// `quiet`. Throws Error(usage) for another name, and what the player throws.
std::unique_ptr<Player> open_player(const std::string& on, const Project& project, bool quiet);

}  // namespace shadertwin::app

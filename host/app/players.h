// Players by the name that --on gives them.
#pragma once

#include <memory>
#include <string>

#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin::app {

// `on`: auto | egl[:N] | osmesa, then /fragment or /compute if wanted. Prints the player's warnings unless
// `quiet`. Throws Error(usage) for another name, and what the player throws.
std::unique_ptr<Player> open_player(const std::string& on, const Project& project, bool quiet);

}  // namespace shadertwin::app

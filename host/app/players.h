// Players by the name that --on gives them.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "host/app/options.h"
#include "host/gl/gl_player.h"
#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin::app {

// What follows the slash in the name of an OpenGL player. Throws Error(usage) if it is neither fragment nor
// compute.
gl::Dispatch dispatch_of(const std::string& on);

// `on`: auto | egl[:N] | llvmpipe | osmesa, then /fragment or /compute if wanted; or cpu | cpu/double. Prints
// the player's warnings unless --quiet, but not those in `told`, which keeps them. Throws Error(usage) for
// another name or an option that the player can't take, and what the player throws.
std::unique_ptr<Player> open_player(const std::string& on, const Project& project, const PlayOptions& options,
                                    std::set<std::string>* told = nullptr);

}  // namespace shadertwin::app

// Players by the choice that --on gives.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "host/app/options.h"
#include "host/player/player.h"
#include "host/project/project.h"

namespace shadertwin::app {

enum class Timers { off, gpu };  // gpu: Player::milliseconds() tells what a GPU measures

// Prints the player's warnings unless --quiet, but not those in `told`, which keeps them. Throws Error(usage)
// for an option that the player can't take, and what the player throws.
std::unique_ptr<Player> open_player(const DeviceChoice& on, const Project& project,
                                    const PlayOptions& options, std::set<std::string>* told = nullptr,
                                    Timers timers = Timers::off);

}  // namespace shadertwin::app

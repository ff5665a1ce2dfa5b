#include "host/app/players.h"

#include <cstdio>

#include "host/base/error.h"
#include "host/gl/gl_player.h"

namespace shadertwin::app {

gl::Dispatch dispatch_of(const std::string& on) {
  const std::size_t slash = on.find('/');
  if (slash == std::string::npos) return gl::Dispatch::automatic;
  const std::string how = on.substr(slash + 1);
  if (how != "fragment" && how != "compute")
    throw Error(ExitStatus::usage, "--on " + on + ": expected /fragment or /compute");
  return how == "compute" ? gl::Dispatch::compute : gl::Dispatch::fragment;
}

std::unique_ptr<Player> open_player(const std::string& on, const Project& project, bool quiet) {
  gl::PlayerOptions options;
  options.dispatch = dispatch_of(on);
  const std::string device = on.substr(0, on.find('/'));
  auto player = gl::GlPlayer::create(gl::open_context(device), project, options);
  if (!quiet)
    for (const std::string& warning : player->warnings()) std::fprintf(stderr, "%s\n", warning.c_str());
  return player;
}

}  // namespace shadertwin::app

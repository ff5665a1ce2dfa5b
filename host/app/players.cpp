#include "host/app/players.h"

#include <cstdio>

#include "host/base/error.h"
#include "host/gl/gl_player.h"
#include "reference/twin/twin_player.h"

namespace shadertwin::app {

namespace {

std::unique_ptr<Player> open_gl(const std::string& on, const Project& project) {
  const std::string device = on.substr(0, on.find('/'));
  gl::PlayerOptions options;
  options.dispatch = dispatch_of(on);
  return gl::GlPlayer::create(gl::open_context(device), project, options);
}

std::unique_ptr<Player> open_twin(const std::string& how, const Project& project,
                                  const PlayOptions& options) {
  if (!how.empty() && how != "double")
    throw Error(ExitStatus::usage, "--on cpu/" + how + ": expected cpu or cpu/double");
  twin::TwinOptions twin_options;
  twin_options.double_precision = how == "double";
  twin_options.timeout = options.timeout;
  if (!options.tile.empty()) {
    const TileRegion tile = parse_tile(options.tile);
    twin_options.region = twin::Rectangle{tile.x, tile.y, tile.width, tile.height};
  }
  return twin::TwinPlayer::create(project, twin_options);
}

}  // namespace

gl::Dispatch dispatch_of(const std::string& on) {
  const std::size_t slash = on.find('/');
  if (slash == std::string::npos) return gl::Dispatch::automatic;
  const std::string how = on.substr(slash + 1);
  if (how != "fragment" && how != "compute")
    throw Error(ExitStatus::usage, "--on " + on + ": expected /fragment or /compute");
  return how == "compute" ? gl::Dispatch::compute : gl::Dispatch::fragment;
}

std::unique_ptr<Player> open_player(const std::string& on, const Project& project, const PlayOptions& options,
                                    std::set<std::string>* told) {
  const std::size_t slash = on.find('/');
  const std::string device = on.substr(0, slash);
  const std::string how = slash == std::string::npos ? "" : on.substr(slash + 1);
  const bool twin = device == "cpu";
  if (!twin && (!options.tile.empty() || options.timeout > 0.0))
    throw Error(ExitStatus::usage, "--tile and --timeout are for --on cpu only");
  auto player = twin ? open_twin(how, project, options) : open_gl(on, project);
  if (!options.quiet)
    for (const std::string& warning : player->warnings())
      if (told == nullptr || told->insert(warning).second) std::fprintf(stderr, "%s\n", warning.c_str());
  return player;
}

}  // namespace shadertwin::app

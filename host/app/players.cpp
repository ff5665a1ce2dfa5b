#include "host/app/players.h"

#include <cstdio>

#include "host/gl/gl_device.h"
#include "reference/twin/twin_device.h"

namespace shadertwin::app {

namespace {

std::unique_ptr<Player> open_gl(const DeviceChoice& on, const Project& project, Timers timers) {
  auto context = gl::open_context(on.device);
  gl::PlayerOptions options;
  options.dispatch = on.dispatch;
  options.timers = timers == Timers::gpu && !context->info().software;
  return gl::make_player(std::move(context), project, options);
}

std::unique_ptr<Player> open_twin(const DeviceChoice& on, const Project& project,
                                  const PlayOptions& options) {
  twin::TwinOptions twin_options;
  twin_options.double_precision = on.double_precision;
  twin_options.timeout = options.timeout;
  if (options.tile.has_value()) {
    const Region& tile = *options.tile;
    twin_options.region = twin::Rectangle{tile.x, tile.y, tile.width, tile.height};
  }
  return twin::make_player(project, twin_options);
}

}  // namespace

std::unique_ptr<Player> open_player(const DeviceChoice& on, const Project& project,
                                    const PlayOptions& options, std::set<std::string>* told, Timers timers) {
  refuse_for_player(options, on);
  auto player = on.is_twin() ? open_twin(on, project, options) : open_gl(on, project, timers);
  if (!options.quiet)
    for (const std::string& warning : player->warnings())
      if (told == nullptr || told->insert(warning).second) std::fprintf(stderr, "%s\n", warning.c_str());
  return player;
}

}  // namespace shadertwin::app

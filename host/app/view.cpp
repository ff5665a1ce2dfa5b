#include "host/view/view.h"

#include <memory>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/players.h"

namespace shadertwin::app {

namespace {

struct ViewCommand : PlayOptions {
  bool paused = false;
  bool fixed_rate = false;
  std::string output;
};

void run(const ViewCommand& o, CommandLine command) {
  refuse_for_player(o, o.on);
  const Schedule& schedule = o.schedule;
  view::ViewOptions options;
  options.shader = o.shader;
  options.load = o.load;
  options.accept = [&o](const Project& project) { refuse_for_project(o, project); };
  options.size = {schedule.width, schedule.height};
  options.clock = {.t0 = schedule.t0, .rate = {}, .date = {}, .paused = o.paused};
  if (o.fixed_rate) options.clock.rate = schedule.fps;
  if (o.fixed_rate || command.given("--date")) options.clock.date = schedule.date;
  options.recording_rate = schedule.fps;
  options.pass = o.pass;
  options.output = o.output;
  options.options_text = options_text(o);
  options.quiet = o.quiet;
  if (o.on.device == "auto")
    options.player.dispatch = o.on.dispatch;
  else
    options.other_player = [o](const Project& project) { return open_player(o.on, project, o); };
  options.sound_player = [o](const Project& project) { return open_player(o.on, project, o); };
  view::run_view(options);
}

}  // namespace

void add_view(CommandLine app) {
  const CommandLine command =
      app.add_subcommand("view", "play a shader in a window, reloading it when its files are saved");
  const auto options = std::make_shared<ViewCommand>();
  add_options(command, Command::view, *options);
  command.add_flag("--fixed", options->fixed_rate,
                   "time goes by frames at --fps, as render's does, instead of by the clock");
  command.add_flag("--paused", options->paused, "stop after the first frame");
  command.add_option(
      "-o,--output", options->output,
      "screenshots are OUTPUT_0001.png and .exr, recordings OUTPUT_recording_0001/ (the shader's name, "
      "in this folder)");
  command.callback([options, command] { run(*options, command); });
}

}  // namespace shadertwin::app

#include "host/view/view.h"

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/players.h"
#include "host/view/shown_text.h"

namespace shadertwin::app {

namespace {

struct ViewCommand : PlayOptions {
  bool paused = false;
  bool fixed_rate = false;
  std::string output;
};

// The options that change what a frame looks like, to be typed again.
std::string options_text(const ViewCommand& o) {
  std::string text;
  const auto add = [&text](const std::string& option, const std::string& value) {
    text += (text.empty() ? "" : " ") + option + ' ' + view::quoted(value);
  };
  for (const std::string& define : o.defines) add("-D", define);
  if (!o.seed.empty()) add("--seed", o.seed);
  if (o.vscode_quirks) text += (text.empty() ? "" : " ") + std::string("--vscode-quirks");
  if (o.init != "zero") add("--init", o.init);
  if (o.vr) text += text.empty() ? "--vr" : " --vr";
  return text;
}

void run(const ViewCommand& o) {
  const Schedule schedule = make_schedule(o);
  view::ViewOptions options;
  options.shader = o.shader;
  options.load = make_load_options(o);
  options.size = {schedule.width, schedule.height};
  options.clock = {.t0 = schedule.t0, .rate = {}, .date = {}, .paused = o.paused};
  if (o.fixed_rate) options.clock.rate = schedule.fps;
  if (o.fixed_rate || !o.date.empty()) options.clock.date = schedule.date;
  options.recording_rate = schedule.fps;
  options.pass = o.pass;
  options.output = o.output;
  options.options_text = options_text(o);
  options.quiet = o.quiet;
  options.player.rewrite = rewrite_for_gl(o);
  if (o.on == "auto" || o.on.starts_with("auto/"))
    options.player.dispatch = dispatch_of(o.on);
  else
    options.other_player = [o](const Project& project) { return open_player(o.on, project, o); };
  options.sound_player = [o](const Project& project) { return open_player(o.on, project, o); };
  view::run_view(options);
}

}  // namespace

void add_view(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("view", "play a shader in a window, reloading it when its files are saved");
  const auto options = std::make_shared<ViewCommand>();
  add_shader_options(*command, *options);
  add_on_option(*command, *options);
  command->add_flag("--fixed", options->fixed_rate,
                    "time goes by frames at --fps, as render's does, instead of by the clock");
  command->add_flag("--paused", options->paused, "stop after the first frame");
  command->add_option(
      "-o,--output", options->output,
      "screenshots are OUTPUT_0001.png and .exr, recordings OUTPUT_recording_0001/ (the shader's name, "
      "in this folder)");
  command->callback([options] { run(*options); });
}

}  // namespace shadertwin::app

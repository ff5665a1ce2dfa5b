#include "host/view/view.h"

#include <set>

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

// What was given, to be typed again behind a command that looks into a frame.
std::string options_text(const CLI::App& command) {
  // view::commands_for_pixel() says those of the frame itself; the others change nothing of a pixel.
  static const std::set<std::string> left_out = {"SHADER", "--size",    "--fps",    "--time",  "--date",
                                                 "--pass", "--on",      "--output", "--fixed", "--paused",
                                                 "--tile", "--timeout", "--quiet"};
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || left_out.contains(option->get_name())) continue;
    const std::string name =
        option->get_snames().empty() ? option->get_name() : '-' + option->get_snames()[0];
    const bool is_flag = option->get_items_expected_max() == 0;
    const bool takes_all = option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    const std::vector<std::string>& words = option->results();
    for (std::size_t i = takes_all ? 0 : words.size() - 1; i < words.size(); ++i)
      text += (text.empty() ? "" : " ") + name + (is_flag ? "" : ' ' + view::quoted(words[i]));
  }
  return text;
}

void run(const ViewCommand& o, const CLI::App& command) {
  refuse_for_gl(o, o.on);
  const Schedule& schedule = o.schedule;
  view::ViewOptions options;
  options.shader = o.shader;
  options.load = make_load_options(o);
  options.size = {schedule.width, schedule.height};
  options.clock = {.t0 = schedule.t0, .rate = {}, .date = {}, .paused = o.paused};
  if (o.fixed_rate) options.clock.rate = schedule.fps;
  if (o.fixed_rate || command.count("--date") > 0) options.clock.date = schedule.date;
  options.recording_rate = schedule.fps;
  options.pass = o.pass;
  options.output = o.output;
  options.options_text = options_text(command);
  options.quiet = o.quiet;
  if (o.on.device == "auto")
    options.player.dispatch = o.on.dispatch;
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
  add_project_options(*command, *options);
  add_init_option(*command, *options);
  add_precise_option(*command, *options);
  add_frame_options(*command, *options);
  add_pass_option(*command, *options);
  add_on_option(*command, *options);
  add_tile_option(*command, *options);
  add_timeout_option(*command, *options);
  command->add_flag("--fixed", options->fixed_rate,
                    "time goes by frames at --fps, as render's does, instead of by the clock");
  command->add_flag("--paused", options->paused, "stop after the first frame");
  command->add_option(
      "-o,--output", options->output,
      "screenshots are OUTPUT_0001.png and .exr, recordings OUTPUT_recording_0001/ (the shader's name, "
      "in this folder)");
  command->callback([options, command] { run(*options, *command); });
}

}  // namespace shadertwin::app

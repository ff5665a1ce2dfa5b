#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/output.h"
#include "host/app/players.h"
#include "host/app/progress.h"
#include "host/app/render_sound.h"
#include "host/app/report.h"
#include "host/app/video_sound.h"
#include "host/base/error.h"
#include "host/image/image.h"
#include "host/media/video_writer.h"
#include "host/player/inputs.h"
#include "host/player/sound.h"
#include "host/project/kinds.h"

namespace shadertwin::app {

namespace {

using Clock = std::chrono::steady_clock;

struct RenderOptions : PlayOptions {
  OutputOptions output;
  std::optional<double> duration;  // seconds
};

// How many frames to draw before waiting for the device: enough that it never idles, so few that the bar
// moves and Ctrl-C works.
class Batch {
 public:
  void drawn(Player& player) {
    if (++pending_ < size_) return;
    player.finish();
    const auto now = Clock::now();
    constexpr auto target = std::chrono::milliseconds(50);
    if (now - start_ < target / 2 && size_ < 64) size_ *= 2;
    if (now - start_ > target && size_ > 1) size_ /= 2;
    start_ = now;
    pending_ = 0;
  }

 private:
  int pending_ = 0;
  int size_ = 1;
  Clock::time_point start_ = Clock::now();
};

nlohmann::json statistics(const Image& image) {
  std::size_t nan = 0;
  std::size_t infinite = 0;
  std::size_t negative = 0;
  double sum = 0.0;
  std::size_t finite = 0;
  float low = INFINITY;
  float high = -INFINITY;
  for (const float value : image.rgba) {
    if (std::isnan(value)) {
      ++nan;
    } else if (std::isinf(value)) {
      ++infinite;
    } else {
      ++finite;
      sum += value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (value < 0.0F) ++negative;
  }
  nlohmann::json j = {{"nan", nan}, {"inf", infinite}, {"negative", negative}};
  if (finite != 0) j.update({{"min", low}, {"max", high}, {"mean", sum / static_cast<double>(finite)}});
  return j;
}

double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

void render_frames(const RenderOptions& options) {
  if (output_kind(options.output.name) == OutputKind::sound)
    return render_sound(options, options.duration.value_or(sound_seconds), options.output.name);
  const Schedule& schedule = options.schedule;
  const Project project = load(options);
  const int shown = chosen_pass(project, options);
  if (options.tile.has_value() && static_cast<std::size_t>(shown) + 1 != project.passes.size())
    throw Error(ExitStatus::usage,
                "--tile is for the last pass: " + project.passes[static_cast<std::size_t>(shown)].name +
                    " is always drawn whole");
  OutputOptions output_options = options.output;
  output_options.sound = has_sound(project);
  const auto output = open_output(output_options,
                                  picture_size(traits(project.passes[static_cast<std::size_t>(shown)]),
                                               {schedule.width, schedule.height}),
                                  schedule.fps);
  const auto player = open_player(options.on, project, options);
  std::optional<VideoSound> sound;
  if (output->wants_sound()) sound.emplace(project, schedule, *player);

  FixedClock clock(schedule, host_rules(project));
  Batch batch;
  const auto start = Clock::now();
  auto first_drawn = start;
  {
    Progress progress("rendering", options.frames, options.quiet);
    for (int i = 0; i < options.frames; ++i) {
      player->render(clock.next());
      if (output->wants_every_frame())
        output->add(player->read(shown));
      else
        batch.drawn(*player);
      if (i == 0) {
        player->finish();
        first_drawn = Clock::now();
      }
      if (sound) output->add_sound(sound->next_frame());
      progress.update(i + 1);
    }
    player->finish();
  }
  const auto drawn = Clock::now();
  if (!output->wants_every_frame()) output->add(player->read(shown));
  output->finish();
  if (sound && sound->pass() != nullptr && !options.quiet)
    print_warnings(*sound->pass(), options.output.name);
  if (!options.json.empty()) {
    nlohmann::json passes = nlohmann::json::array();
    for (std::size_t i = 0; i < project.passes.size(); ++i)
      if (traits(project.passes[i]).every_frame) {
        nlohmann::json entry = {{"name", project.passes[i].name}};
        entry.update(statistics(player->read(static_cast<int>(i))));
        passes.push_back(entry);
      }
    write_report(options.json,
                 {{"device", player->description()},
                  {"size", {schedule.width, schedule.height}},
                  {"frames", options.frames},
                  {"seconds", milliseconds(drawn - start) / 1000.0},
                  {"first_frame_milliseconds", milliseconds(first_drawn - start)},
                  {"milliseconds_per_frame", options.frames == 1
                                                 ? milliseconds(drawn - start)
                                                 : milliseconds(drawn - first_drawn) / (options.frames - 1)},
                  {"passes", passes}});
  }
}

void refuse_without_effect(CommandLine command, const RenderOptions& options) {
  refuse_for_player(options, options.on);
  const OutputKind kind = output_kind(options.output.name);
  if (kind == OutputKind::sound) {
    const std::string why = "has no effect on the Sound pass: " + options.output.name;
    refuse(options, NoEffect::on_sound, why);
    return refuse(command, {"--crf", "--chroma"}, why);
  }
  if (kind == OutputKind::picture)
    refuse(command, {"--duration"}, "is for videos, numbered pictures and sounds: " + options.output.name);
  if (kind != OutputKind::video)
    refuse(command, {"--crf", "--chroma"}, "is for videos: " + options.output.name);
  if (options.duration.has_value()) refuse(command, {"--frames"}, "and --duration say the same twice");
}

int frames_of(double seconds, double fps) {
  const double frames = std::round(seconds * fps);
  if (frames > std::numeric_limits<int>::max())
    throw Error(ExitStatus::usage, "--duration is more than there are numbers for frames");
  return std::max(1, static_cast<int>(frames));
}

}  // namespace

void add_render(CommandLine app) {
  const CommandLine command = app.add_subcommand(
      "render", "play a shader without a window and write the picture, the video or the sound");
  const auto options = std::make_shared<RenderOptions>();
  add_options(command, Command::render, *options);
  command.add_option("-o,--output", options->output.name, "what to write: " + output_help()).required();
  command
      .add_option("--crf", options->output.crf,
                  "quality of a video, by its constant rate factor: " + media::crf_help())
      .not_negative()
      .default_str("");
  add_choice<bool, bool>(
      command, "--chroma", options->output.full_chroma, {{"420", false}, {"444", true}},
      "420: a video keeps one colour for every four pixels, as all programs can play it; 444: it "
      "keeps all",
      "420");
  add_value(command, "--duration", options->duration, read_rate,
            "seconds from --time on, of a video or numbered pictures instead of --frames, or of the Sound "
            "pass, else " +
                std::to_string(static_cast<int>(sound_seconds)) + " as on shadertoy.com")
      .type_name("FLOAT");
  command.callback([options, command] {
    refuse_without_effect(command, *options);
    options->output.quiet = options->quiet;
    if (!command.given("--fps") && media::is_video(options->output.name))
      options->schedule.fps = std::min(options->schedule.fps, media::highest_rate(options->output.name));
    if (options->duration.has_value()) options->frames = frames_of(*options->duration, options->schedule.fps);
    render_frames(*options);
  });
}

}  // namespace shadertwin::app

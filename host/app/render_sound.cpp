#include "host/app/render_sound.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/app/players.h"
#include "host/app/progress.h"
#include "host/app/report.h"
#include "host/base/error.h"
#include "host/media/audio_writer.h"
#include "host/player/sound.h"

namespace shadertwin::app {

namespace {

// Above, the samples would not fit into a .wav, and iTime is no longer exact to a sample anyway.
constexpr double max_seconds = 3.0 * 3600.0;

}  // namespace

void render_sound(const PlayOptions& options, double seconds, const std::string& output) {
  const Schedule& schedule = options.schedule;
  if (!(seconds > 0.0) || seconds > max_seconds || std::abs(schedule.t0) > max_seconds ||
      schedule.t0 + seconds > max_seconds)
    throw Error(ExitStatus::usage, "--duration must be above 0, and the sound end within three hours");
  const auto count = static_cast<std::int64_t>(std::llround(seconds * sound_rate));
  const auto first = static_cast<std::int64_t>(std::llround(schedule.t0 * sound_rate));
  const Project project = sound_only(load(options));
  media::AudioWriter writer(output, sound_rate);  // an output that can't be written fails before the work
  const auto player = open_player(options.on, project, options);
  Sound sound(*player, shader_date(schedule.date, 0.0), first);

  const auto start = std::chrono::steady_clock::now();
  {
    // A tenth of a second at a time.
    constexpr std::int64_t step = sound_rate / 10;
    Progress progress("rendering", static_cast<int>((count + step - 1) / step), options.quiet);
    std::vector<float> stereo;
    for (std::int64_t done = 0; done < count; done += step) {
      stereo.resize(static_cast<std::size_t>(std::min(step, count - done)) * 2);
      sound.read(stereo);
      writer.write(stereo);
      progress.update(static_cast<int>(done / step) + 1);
    }
  }
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writer.finish();
  if (!options.quiet) print_warnings(sound, output);
  if (!options.json.empty())
    write_report(options.json, {{"device", player->description()},
                                {"samples", count},
                                {"rate", sound_rate},
                                {"seconds", taken},
                                {"nan", sound.nan_values()},
                                {"clipped", sound.clipped_values()}});
}

void print_warnings(const Sound& sound, const std::string& output) {
  if (sound.nan_values() != 0)
    std::fprintf(stderr, "%s: warning: %lld samples are NaN and became silence\n", output.c_str(),
                 static_cast<long long>(sound.nan_values()));
  if (sound.clipped_values() != 0)
    std::fprintf(stderr, "%s: warning: %lld samples were beyond [-1, 1] and are clipped\n", output.c_str(),
                 static_cast<long long>(sound.clipped_values()));
}

}  // namespace shadertwin::app

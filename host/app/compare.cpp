#include "host/compare/compare.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/players.h"
#include "host/app/progress.h"
#include "host/app/report.h"
#include "host/base/error.h"
#include "host/project/kinds.h"

namespace shadertwin::app {

namespace {

struct CompareOptions : PlayOptions {
  std::vector<DeviceChoice> players;
  std::string heatmap;
  bool every_frame = false;
  std::uint32_t max_ulp = nan_distance;  // the largest distance that passes
  double min_equal = 0.0;                // percent
};

constexpr std::array<char, 4> channel_names = {'r', 'g', 'b', 'a'};

struct PassDifference {
  int pass = 0;
  std::array<ChannelDifference, 4> channels;

  bool within(const CompareOptions& options) const {
    return std::all_of(channels.begin(), channels.end(), [&](const ChannelDifference& c) {
      return c.ulp_max <= options.max_ulp && 100.0 * c.equal_share() >= options.min_equal;
    });
  }
  bool equal() const {
    return std::all_of(channels.begin(), channels.end(), [](const auto& c) { return c.equal == c.pixels; });
  }
};

std::string distance_text(std::uint32_t ulp) {
  return ulp == nan_distance ? "nan" : std::to_string(ulp);
}

void print(const Project& project, const std::vector<PassDifference>& passes) {
  std::printf("%-14s ch   bit-equal   ULP p50     p99     max   NaN A/B  Inf A/B  worst pixel\n", "pass");
  for (const PassDifference& pass : passes)
    for (std::size_t i = 0; i < 4; ++i) {
      const ChannelDifference& c = pass.channels[i];
      std::printf("%-14s %c  %9.4f %% %9s %7s %7s  %4zu/%-4zu %4zu/%-4zu",
                  i == 0 ? project.passes[static_cast<std::size_t>(pass.pass)].name.c_str() : "",
                  channel_names[i], 100.0 * c.equal_share(), distance_text(c.ulp_p50).c_str(),
                  distance_text(c.ulp_p99).c_str(), distance_text(c.ulp_max).c_str(), c.nan[0], c.nan[1],
                  c.infinite[0], c.infinite[1]);
      if (c.equal != c.pixels)
        std::printf(" (%d, %d) %.9g %.9g", c.worst_x, c.worst_y, static_cast<double>(c.worst[0]),
                    static_cast<double>(c.worst[1]));
      std::printf("\n");
    }
}

nlohmann::json to_json(const Project& project, const std::vector<PassDifference>& passes) {
  nlohmann::json result = nlohmann::json::array();
  for (const PassDifference& pass : passes) {
    nlohmann::json channels = nlohmann::json::object();
    for (std::size_t i = 0; i < 4; ++i) {
      const ChannelDifference& c = pass.channels[i];
      channels[std::string(1, channel_names[i])] = {
          {"equal_percent", 100.0 * c.equal_share()},
          {"ulp_p50", c.ulp_p50},
          {"ulp_p99", c.ulp_p99},
          {"ulp_max", c.ulp_max},
          {"nan", c.nan},
          {"inf", c.infinite},
          {"worst_pixel", {c.worst_x, c.worst_y}},
          // As text: JSON has no NaN and no infinity.
          {"worst_values", {std::to_string(c.worst[0]), std::to_string(c.worst[1])}}};
    }
    result.push_back(
        {{"name", project.passes[static_cast<std::size_t>(pass.pass)].name}, {"channels", channels}});
  }
  return result;
}

void run_compare(const CompareOptions& options) {
  if (options.players.size() != 2)
    throw Error(ExitStatus::usage, "compare needs --on twice, once for each of the two players");
  for (const DeviceChoice& player : options.players) refuse_for_player(options, player);
  const Schedule& schedule = options.schedule;
  const Project project = load(options);
  std::set<std::string> told;
  const auto a = open_player(options.players[0], project, options, &told);
  const auto b = open_player(options.players[1], project, options, &told);
  FixedClock clock(schedule, host_rules(project));

  const int only = options.pass.empty() ? -1 : chosen_pass(project, options);
  const auto measure = [&] {
    std::vector<PassDifference> passes;
    for (int i = 0; i < static_cast<int>(project.passes.size()); ++i)
      if ((only < 0 || i == only) && traits(project.passes[static_cast<std::size_t>(i)]).every_frame)
        passes.push_back({i, shadertwin::compare(a->read(i), b->read(i))});
    return passes;
  };

  int first_difference = -1;
  std::vector<PassDifference> passes;
  {
    Progress progress("comparing", options.frames, options.quiet);
    for (int i = 0; i < options.frames; ++i) {
      const Frame frame = clock.next();
      a->render(frame);
      b->render(frame);
      if (options.every_frame || i + 1 == options.frames) {
        passes = measure();
        const bool equal = std::all_of(passes.begin(), passes.end(), [](const auto& p) { return p.equal(); });
        if (!equal && first_difference < 0) first_difference = i;
      } else if (progress.visible()) {
        a->finish();
        b->finish();
      }
      progress.update(i + 1);
    }
  }

  if (!options.quiet) {
    std::printf("A: %s\nB: %s\nframe %d, %dx%d\n", a->description().c_str(), b->description().c_str(),
                options.frames - 1, schedule.width, schedule.height);
    print(project, passes);
    if (options.every_frame && first_difference >= 0)
      std::printf("first difference: frame %d\n", first_difference);
  }
  const bool within =
      std::all_of(passes.begin(), passes.end(), [&](const auto& p) { return p.within(options); });
  if (!options.heatmap.empty()) {
    const int shown = chosen_pass(project, options);
    write_image(heatmap(a->read(shown), b->read(shown)), options.heatmap);
  }
  if (!options.json.empty()) {
    nlohmann::json report = {{"a", a->description()},
                             {"b", b->description()},
                             {"frame", options.frames - 1},
                             {"size", {schedule.width, schedule.height}},
                             {"passes", to_json(project, passes)},
                             {"within_limits", within}};
    if (options.every_frame) report["first_difference"] = first_difference;
    write_report(options.json, report);
  }
  if (!within)
    throw Error(ExitStatus::failed, options.players[0].text + " and " + options.players[1].text +
                                        " differ by more than --max-ulp and --min-equal allow");
}

}  // namespace

void add_compare(CommandLine app) {
  const CommandLine command =
      app.add_subcommand("compare", "play the same frames on two players and say how far they are apart");
  const auto options = std::make_shared<CompareOptions>();
  add_options(command, Command::compare, *options);
  add_repeated(
      command, "--on", [options](const std::string& word) { options->players.push_back(read_device(word)); },
      "a player, as render takes it; give it twice")
      .required();
  command.add_flag("--every-frame", options->every_frame,
                   "compare every frame, and name the first that differs");
  command.add_option("--heatmap", options->heatmap,
                     "write a picture of where they differ: " + list_of(image_formats()));
  command
      .add_option("--max-ulp", options->max_ulp,
                  "exit with 1 if a channel of a pass differs by more units in the last place")
      .default_str("no limit");
  command
      .add_option("--min-equal", options->min_equal,
                  "exit with 1 if less than this percentage of a channel of a pass has the same bits")
      .between(0.0, 100.0);
  command.callback([options] { run_compare(*options); });
}

}  // namespace shadertwin::app

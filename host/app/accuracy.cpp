#include <algorithm>
#include <cstdio>
#include <memory>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/app/progress.h"
#include "host/app/report.h"
#include "host/base/error.h"
#include "host/player/inputs.h"
#include "host/project/kinds.h"
#include "reference/check/accuracy.h"

namespace shadertwin::app {

namespace {

using check::Accuracy;
using check::AccuracyFinding;

struct JudgeOptions : PlayOptions {
  double threshold = check::AccuracyOptions{}.threshold;
  double least_bits = 8.0;
  bool all = false;
  std::optional<double> max_error;
  std::string heatmap;
  std::optional<glm::ivec2> pixel;
};

int picture_of(const Project& project, const JudgeOptions& options) {
  const int pass = chosen_pass(project, options);
  const Pass& chosen = project.passes[static_cast<std::size_t>(pass)];
  if (!traits(chosen).every_frame)
    throw Error(ExitStatus::usage,
                options.shader + ": " + chosen.name + " is a sound: accuracy judges pictures");
  return pass;
}

// JSON has no infinity.
nlohmann::json number(double x) {
  return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(std::to_string(x));
}

nlohmann::json place(const twin::PixelPlace& at) {
  return {{"pixel", {at.x, at.y}}, {"frame", at.frame}};
}

nlohmann::json numbers(const twin::ShadowNumber* first, int count) {
  nlohmann::json list = nlohmann::json::array();
  for (int i = 0; i < count; ++i)
    list.push_back({{"float", number(first[i].value)}, {"exact", number(first[i].exact)}});
  return list;
}

nlohmann::json to_json(const AccuracyFinding& finding) {
  const check::Operation& o = *finding.operation;
  nlohmann::json entry = {{"file", finding.file},
                          {"line", finding.line},
                          {"kind", finding.kind},
                          {"expression", o.text},
                          {"text", finding.text}};
  if (finding.kind == "branch") {
    entry["pixels_that_differ"] = o.record.parted;
    entry["first"] = place(o.record.parted_at);
    entry["sides"] = numbers(o.record.sides, o.record.is_number ? 1 : 2);
    entry["picture"] = {{"pixels_tried", o.record.tried},
                        {"pixels", o.record.moved},
                        {"error", o.record.moved_by},
                        {"worst", place(o.record.moved_at)}};
    return entry;
  }
  entry["times"] = o.record.losses;
  entry["bits_lost"] = finding.bits;
  entry["relative_error"] = number(o.record.own);
  entry["worst"] = place(o.record.lost_at);
  entry["operands"] = numbers(o.record.operands, o.record.operand_count);
  entry["result"] = numbers(&o.record.result, 1)[0];
  entry["picture"] = {
      {"pixels", o.pixels}, {"not_numbers", o.not_numbers}, {"error", o.error}, {"worst", place(o.at)}};
  return entry;
}

nlohmann::json to_json(const check::Line& line) {
  const twin::NumberRecord& r = line.record;
  const auto finite = static_cast<double>(r.numbers - r.not_finite);
  nlohmann::json entry = {{"file", line.file},
                          {"line", line.line},
                          {"numbers", r.numbers},
                          {"mean_relative_error", finite > 0.0 ? r.error_sum / finite : 0.0},
                          {"worst_relative_error", r.error},
                          {"without_a_relative_error", r.not_finite}};
  entry["worst"] = place(r.error_at);
  return entry;
}

nlohmann::json to_json(const Accuracy& accuracy, const std::vector<AccuracyFinding>& findings,
                       const JudgeOptions& options) {
  nlohmann::json list = nlohmann::json::array();
  for (const AccuracyFinding& finding : findings) list.push_back(to_json(finding));
  nlohmann::json lines = nlohmann::json::array();
  for (const check::Line& line : accuracy.lines) lines.push_back(to_json(line));
  return {{"frames", options.frames},
          {"size", {options.schedule.width, options.schedule.height}},
          {"threshold", options.threshold},
          {"picture",
           {{"pixels", accuracy.drawn},
            {"pixels_over_threshold", accuracy.pixels},
            {"without_origin", accuracy.without_origin},
            {"not_numbers", accuracy.not_numbers},
            {"worst_error", accuracy.error},
            {"mean_error", accuracy.mean_error},
            {"worst", place(accuracy.at)}}},
          {"findings", list},
          {"lines", lines}};
}

std::string both(const twin::ShadowNumber& x) {
  char text[80];
  std::snprintf(text, sizeof text, "%.9g (exactly %.9g)", static_cast<double>(x.value), x.exact);
  return text;
}

void print_story(const Accuracy& accuracy, const Project& project, const JudgeOptions& options, int pass) {
  for (const check::Told& told : accuracy.told) {
    if (told.file.empty()) continue;
    std::string from;
    for (const twin::ShadowNumber& operand : told.operands)
      from += (from.empty() ? "" : ", ") + both(operand);
    const double share = std::min(
        1.0, std::fabs(told.result.value - told.result.exact) /
                 std::max(std::fabs(static_cast<double>(told.result.value)), std::fabs(told.result.exact)));
    std::printf("%s:%d: %s: from %s comes %s: %.0f bits off, %.0f of them lost here\n", told.file.c_str(),
                told.line, told.text.c_str(), from.c_str(), both(told.result).c_str(),
                check::bits_lost(share), std::min(check::bits_lost(share), check::bits_lost(told.own)));
  }
  if (accuracy.untold != 0) std::printf("... and %zu more\n", accuracy.untold);
  std::printf("pixel %d,%d of %s in frame %d:", options.pixel->x, options.pixel->y,
              project.passes[static_cast<std::size_t>(pass)].name.c_str(), options.frames - 1);
  for (const twin::ShadowNumber& channel : accuracy.told_pixel) std::printf(" %s", both(channel).c_str());
  std::printf("\n");
}

// Of findings, where one pixel is told instead.
void refuse_without_effect(CommandLine command, const JudgeOptions& options) {
  if (options.pixel && options.json.empty())
    refuse(command, {"--threshold", "--all"},
           "is of findings, and --pixel tells none: leave one of them out");
}

void run_accuracy(const JudgeOptions& options) {
  const Project project = load(options, Warnings::of_loading);
  check::AccuracyOptions judged;
  judged.run = {options.schedule, options.frames, options.timeout};
  judged.pass = picture_of(project, options);
  judged.threshold = options.threshold;
  judged.pixel = options.pixel;
  if (options.pixel)
    check_pixel(*options.pixel, picture_size(traits(project.passes[static_cast<std::size_t>(judged.pass)]),
                                             {options.schedule.width, options.schedule.height}));
  Accuracy accuracy;
  {
    Progress progress("measuring", options.frames, options.quiet);
    accuracy = check::measure_accuracy(project, judged, [&](int done) { progress.update(done); });
  }
  const std::vector<AccuracyFinding> findings =
      check::accuracy_findings(accuracy, options.all ? std::optional(options.least_bits) : std::nullopt);
  if (options.pixel) {
    print_story(accuracy, project, options, judged.pass);
  } else {
    for (const AccuracyFinding& finding : findings) std::printf("%s\n", check::to_line(finding).c_str());
  }
  if (!options.heatmap.empty()) write_image(accuracy.heatmap, options.heatmap);
  if (!options.json.empty()) write_report(options.json, to_json(accuracy, findings, options));
  if (options.max_error && accuracy.error > *options.max_error) {
    std::fflush(stdout);
    char text[160];
    std::snprintf(text, sizeof text,
                  ": the picture is off by %.3g at pixel %d,%d in frame %d, more than --max-error",
                  accuracy.error, accuracy.at.x, accuracy.at.y, accuracy.at.frame);
    throw Error(ExitStatus::failed, options.shader + text);
  }
}

}  // namespace

void add_accuracy(CommandLine app) {
  const CommandLine command = app.add_subcommand(
      "accuracy", "find the lines that lose digits: the shader in float, with a double beside each number");
  const auto options = std::make_shared<JudgeOptions>();
  options->schedule.width = 128;
  options->schedule.height = 72;
  options->frames = 2;
  add_options(command, Command::accuracy, *options);
  add_value(command, "--threshold", options->threshold, read_share,
            "tell of what moves a pixel by so much: colours go from 0 to 1, and numbers above 1 in a buffer "
            "count relatively",
            "1/512")
      .type_name("FLOAT");
  command.add_flag("--all", options->all,
                   "tell of every operation that loses 8 bits and of every decision that differs, also "
                   "where less than one "
                   "pixel of a thousand shows it or none does");
  add_value(command, "--max-error", options->max_error, read_share,
            "exit with 1 if a pixel of the picture is off by more, from 0 to 1")
      .type_name("FLOAT");
  command.add_option(
      "--heatmap", options->heatmap,
      "write a picture of the logarithm of each pixel's error in the last frame (black: none, blue: "
      "2^-24, red: 1, magenta: just one of float and double is NaN): " +
          list_of(image_formats()));
  add_value(
      command, "--pixel", options->pixel, read_pixel,
      "X,Y: tell instead, in order, every operation with a notable error that makes this pixel in the last "
      "frame, counted from the lower left");
  command.callback([command, options] {
    refuse_without_effect(command, *options);
    run_accuracy(*options);
  });
}

}  // namespace shadertwin::app

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "host/app/command.h"
#include "host/app/progress.h"
#include "host/app/report.h"
#include "host/app/sweep_player.h"
#include "host/base/error.h"
#include "host/compare/errors.h"
#include "host/sweep/report.h"
#include "host/text/knobs.h"

namespace shadertwin::app {

namespace {

using sweep::Axis;
using sweep::Point;

// Throws Error(usage), which lists the knobs, if the shader has none of that name.
void need_knob(const Project& project, const std::string& name) {
  if (mentions(project, name)) return;
  std::string list;
  for (const Knob& knob : find_knobs(project))
    list += (list.empty() ? "" : ", ") + knob.name + "=" + knob.value;
  throw Error(ExitStatus::usage, "-D " + name + ": no pass mentions " + name + "; " +
                                     (list.empty() ? "the shader has no knobs" : "its knobs are " + list));
}

// The value that a macro has where nobody sets it; "" if that isn't known.
std::string default_of(const Project& project, const std::string& name) {
  for (const Knob& knob : find_knobs(project))
    if (knob.name == name) return knob.value;
  return "";
}

// What stands as it is while others are varied, and what the reference is: knobs as the shader has them,
// options as they were given first.
Point base_point(const SweepOptions& options, const Project& project) {
  Point base;
  for (const Axis& axis : options.axes)
    base.push_back(axis.kind == Axis::Kind::define && axis.values.size() > 1 ? default_of(project, axis.name)
                                                                             : axis.values.front());
  return base;
}

// Where the runs of FILE.csv are kept.
std::filesystem::path log_file(const SweepOptions& options) {
  if (options.output.empty()) return {};
  return std::filesystem::path(options.output).replace_extension("runs.csv");
}

// A message without what comes after its first line.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

// With errors that say which picture they are of.
Reference draw_reference(SweepPlayer& player, const Point& right, bool quiet) {
  try {
    Reference reference = player.reference(right);
    std::size_t unusable = 0;
    for (const Image& picture : reference.shown) {
      const PictureError error = picture_error(picture, picture);
      unusable += error.nan + error.infinite;
    }
    if (unusable > 0 && !quiet)
      std::fprintf(stderr,
                   "warning: the reference has %zu values that are NaN or infinite; no error counts them\n",
                   unusable);
    return reference;
  } catch (const Error& error) {
    if (error.status() == ExitStatus::file) throw;
    throw Error(error.status(), "the reference: " + first_line(error.what()));
  }
}

// "the others are measured", or that there are none.
std::string failures_text(std::size_t failures, std::size_t points) {
  if (failures == points) return "no point could be played";
  return std::to_string(failures) + " of " + std::to_string(points) +
         " points could not be played; the others are measured";
}

void run_sweep(SweepOptions& options) {
  // Knobs are looked for in the text as it is.
  const Project project = load(options);
  chosen_pass(project, options);
  for (const Axis& axis : options.axes)
    if (axis.kind == Axis::Kind::define) need_knob(project, axis.name);
  for (const Define& define : options.reference_defines) need_knob(project, define.first);

  const Point base = base_point(options, project);
  const std::vector<Point> points = options.one_at_a_time ? sweep::one_at_a_time(options.axes, base)
                                                          : sweep::all_combinations(options.axes);
  sweep::RunLog log(log_file(options));
  SweepPlayer player(options, project);
  sweep::Report report{
      .axes = options.axes, .results = {}, .devices = {}, .has_reference = options.has_reference()};
  for (const Point& point : points)
    report.results.push_back({.point = point, .failed = "", .summary = {}, .curve = {}});

  if (options.one_at_a_time) report.base = base;

  // For each case, what its reference is.
  std::map<std::string, Reference> references;
  const auto fail = [&](sweep::Result& result, const Error& error) {
    result.failed = first_line(error.what());
    if (!options.quiet)
      std::fprintf(stderr, "%s: %s\n", sweep::label(options.axes, result.point).c_str(),
                   result.failed.c_str());
  };
  const auto finish_round = [&] {
    report.devices = player.devices();
    sweep::find_pareto_fronts(report);
    if (!options.output.empty()) sweep::write_csv(report, options.output);
  };
  {
    const int total = static_cast<int>(points.size()) * options.runs;
    Progress progress("sweeping", total, options.quiet);
    int done = 0;
    std::vector<std::string> keys(points.size());
    // In rounds, so that a machine that gets slower or faster does so for all points.
    for (int run = 0; run < options.runs; ++run) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        sweep::Result& result = report.results[i];
        progress.update(done++);
        if (!result.failed.empty()) continue;
        std::vector<sweep::Measurement> measured;
        const std::string name = sweep::case_label(options.axes, points[i]);
        try {
          if (options.has_reference() && references.count(name) == 0) {
            Point right = base;
            for (std::size_t axis = 0; axis < right.size(); ++axis)
              if (options.axes[axis].is_case) right[axis] = points[i][axis];
            references.emplace(name, draw_reference(player, right, options.quiet));
          }
          const Reference* reference = options.has_reference() ? &references.at(name) : nullptr;
          if (keys[i].empty()) keys[i] = player.key(points[i], reference);
          if (!log.has(keys[i], run, options.frames)) measured = player.run(points[i], run, reference);
        } catch (const Error& error) {
          if (error.status() == ExitStatus::file) throw;
          fail(result, error);
          continue;
        }
        for (sweep::Measurement& m : measured) m.key = keys[i];
        if (!measured.empty()) log.add(measured, sweep::label(options.axes, points[i]));
        std::vector<sweep::Measurement> all = log.of(keys[i]);
        std::erase_if(all, [&](const sweep::Measurement& m) { return m.run > run; });
        result.summary = sweep::summarise(all, options.targets);
        result.curve = sweep::curve(all);
      }
      finish_round();
    }
  }

  if (!options.quiet) std::fputs(sweep::table(report).c_str(), stdout);
  if (!options.json.empty()) write_report(options.json, sweep::to_json(report));
  const auto failures = std::count_if(report.results.begin(), report.results.end(),
                                      [](const sweep::Result& result) { return !result.failed.empty(); });
  if (!options.plot.empty() && failures != static_cast<std::ptrdiff_t>(points.size())) {
    try {
      sweep::write_plot(report, options.shader, options.plot);
    } catch (const Error& error) {
      if (error.status() != ExitStatus::device && error.status() != ExitStatus::failed) throw;
      std::fprintf(stderr, "%s: warning: %s\n", options.plot.c_str(), error.what());
    }
  }
  if (failures > 0)
    throw Error(ExitStatus::failed, failures_text(static_cast<std::size_t>(failures), points.size()));
}

// --- Options ----------------------------------------------------------------

void add_axis(SweepOptions& options, Axis axis) {
  const bool known = std::any_of(options.axes.begin(), options.axes.end(),
                                 [&](const Axis& a) { return a.kind == axis.kind && a.name == axis.name; });
  if (known) throw Error(ExitStatus::usage, "it is there twice");
  options.axes.push_back(std::move(axis));
}

// An axis of values that `read` takes.
template <typename Read>
void add_axis_option(CommandLine command, SweepOptions& options, Axis::Kind kind, const std::string& name,
                     const Read& read, const std::string& help, const std::string& default_text) {
  add_repeated(
      command, "--" + name,
      [&options, kind, name, read](const std::string& word) {
        const std::vector<std::string> values = sweep::split_values(word);
        for (const std::string& value : values) read(value);
        add_axis(options, {kind, name, values, kind == Axis::Kind::size});
      },
      help)
      .default_str(default_text);
}

// One of two words.
auto one_of(const char* a, const char* b) {
  return [a, b](const std::string& word) {
    if (word != a && word != b) throw Error(ExitStatus::usage, std::string("expected ") + a + " or " + b);
  };
}

void add_define_axis(SweepOptions& options, const std::string& word, bool is_case) {
  const Define define = read_define(word);
  if (define.first == "SEED")
    throw Error(ExitStatus::usage, "every run has a SEED of its own; --seed chooses the first");
  add_axis(options, {Axis::Kind::define, define.first, sweep::split_values(define.second), is_case});
}

// A picture's file, or settings.
void read_reference(SweepOptions& options, const std::string& word) {
  if (word.find('=') == std::string::npos) {
    options.reference_file = word;
    return;
  }
  for (const std::string& setting : sweep::split_values(word))
    options.reference_defines.push_back(read_define(setting));
}

double read_target(const std::string& word) {
  const double value = read_rate(word);
  if (!(value < 1.0)) throw Error(ExitStatus::usage, "expected a relative MSE below 1");
  return value;
}

void check_options(SweepOptions& options) {
  if (options.axes.empty())
    throw Error(ExitStatus::usage, "a sweep of nothing: give -D NAME=A,B or another axis");
  for (const Axis& axis : options.axes)
    if (axis.kind == Axis::Kind::on)
      for (const std::string& value : axis.values) refuse_for_player(options, read_device(value));
  if (!options.reference_file.empty() &&
      (options.reference_frames.has_value() || options.reference_on.has_value() ||
       !options.reference_defines.empty()))
    throw Error(ExitStatus::usage, "--reference is either a file or a picture that is drawn");
  if (!options.reference_file.empty() &&
      std::any_of(options.axes.begin(), options.axes.end(),
                  [](const Axis& a) { return a.is_case && a.values.size() > 1; }))
    throw Error(ExitStatus::usage, "--reference FILE is one picture: it can't be for several cases or sizes");
  options.accumulates = options.accumulates || options.reference_frames.has_value();
  if (!options.has_reference() &&
      (options.accumulates || !options.targets.empty() || options.max_frames.has_value()))
    throw Error(ExitStatus::usage, "an error needs a --reference, or --reference-frames");
  if (!options.targets.empty() && !options.accumulates)
    throw Error(ExitStatus::usage,
                "--target is for a picture that gets better with its frames: --accumulates");
  if (options.max_frames.has_value() && options.targets.empty())
    throw Error(ExitStatus::usage, "--max-frames is how far to go for a --target");
  if (!options.output.empty() && std::filesystem::path(options.output).extension() != ".csv")
    throw Error(ExitStatus::usage, "-o " + options.output + ": the table of points is a .csv");
  if (!options.plot.empty()) sweep::need_plot_format(options.plot);
  if (!options.plot.empty() && !options.has_reference())
    throw Error(ExitStatus::usage, "--plot shows an error: it needs a --reference, or --reference-frames");
}

}  // namespace

void add_sweep(CommandLine app) {
  const CommandLine command = app.add_subcommand(
      "sweep",
      "play a shader with many settings and measure what each costs and how far it is from the truth");
  const auto options = std::make_shared<SweepOptions>();
  add_options(command, Command::sweep, *options);
  add_repeated(
      command, "-D,--define", [options](const std::string& word) { add_define_axis(*options, word, false); },
      "NAME=A,B,C: an axis, a macro with several values; one value alone holds for all points");
  add_repeated(
      command, "--case", [options](const std::string& word) { add_define_axis(*options, word, true); },
      "NAME=A,B,C: as -D, of different pictures, as scenes are: each has a reference of its own");
  add_axis_option(command, *options, Axis::Kind::on, "on", read_device, "A,B: players, as render takes them",
                  "auto");
  add_axis_option(command, *options, Axis::Kind::size, "size", read_size,
                  "A,B: WIDTHxHEIGHT in pixels; each size has a reference of its own", "640x360");
  add_axis_option(command, *options, Axis::Kind::init, "init", one_of("zero", "raw"),
                  "zero, raw or zero,raw: as render has it", "zero");
  add_axis_option(command, *options, Axis::Kind::precise, "precise", one_of("off", "on"),
                  "off, on or off,on: as render has it", "off");
  command.add_flag("--one-at-a-time", options->one_at_a_time,
                   "vary one axis at a time around the shader's own values instead of all combinations");
  add_value(command, "--seed", options->seed, read_seed,
            "the SEED of the reference; those of the runs follow", "0")
      .type_name("UINT");
  add_value(command, "--runs", options->runs, read_runs,
            "how often each point is played; with the knob SEED, each time with two other seeds", "4")
      .type_name("INT");
  add_word(
      command, "--reference", [options](const std::string& word) { read_reference(*options, word); },
      "the picture that is right: a file, or NAME=VALUE,...: the shader with these settings and, else, its "
      "own");
  add_value(command, "--reference-frames", options->reference_frames, read_frames,
            "the picture that is right is the shader's own after so many frames; implies --accumulates")
      .type_name("INT");
  add_value(command, "--reference-on", options->reference_on, read_device,
            "draw the picture that is right there");
  command.add_flag("--accumulates", options->accumulates,
                   "the picture gets better from frame to frame: measure it after 1, 2, 4 ... frames");
  add_word(
      command, "--target",
      [options](const std::string& word) {
        for (const std::string& value : sweep::split_values(word))
          options->targets.push_back(read_target(value));
      },
      "A,B: relative MSEs; the time until each is reached is told, by the slope if it is beyond --frames");
  add_value(command, "--max-frames", options->max_frames, read_frames,
            "go on beyond --frames until the least --target is reached, but not beyond this")
      .type_name("INT");
  command.add_option(
      "-o,--output", options->output,
      "write a line for each point into this .csv; single runs go into a .runs.csv and references into .exr "
      "files beside it, from which an interrupted sweep goes on");
  command.add_option("--plot", options->plot, "plot error over time into this .svg or .png, by gnuplot");
  command.callback([options] {
    check_options(*options);
    run_sweep(*options);
  });
}

}  // namespace shadertwin::app

// The results of a sweep for people and for programs.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/sweep/plan.h"
#include "host/sweep/summary.h"

namespace shadertwin::sweep {

struct Result {
  Point point;
  std::string failed;  // why it could not be played; else empty
  Summary summary;
  std::vector<Summary> curve;       // by frames, where the picture was measured on its way
  std::vector<Summary> front = {};  // what of the curve is on the Pareto front of its case

  bool pareto() const { return !front.empty(); }
};

struct Report {
  std::vector<Axis> axes;
  Point base = {};  // that the points differ from in one axis each; empty: they are all combinations
  std::vector<Result> results;
  std::vector<std::string> devices;  // that the points were played on
  bool has_reference = false;
};

// Fills in Result::front.
void find_pareto_fronts(Report& report);

// One line a point: the axes, then what Summary holds. Throws Error(file).
void write_csv(const Report& report, const std::filesystem::path& file);
nlohmann::json to_json(const Report& report);
// A table for a terminal; * stands at the points of the Pareto front.
std::string table(const Report& report);

// Error over time on logarithmic axes, a panel for each case and axis, the Pareto front drawn and named.
// Drawn by gnuplot into .svg or .png. Throws Error(usage) for another extension, Error(device) if there is no
// gnuplot or it fails, and Error(file).
void write_plot(const Report& report, const std::string& title, const std::filesystem::path& file);
// Throws Error(usage) if write_plot() would.
void need_plot_format(const std::filesystem::path& file);

}  // namespace shadertwin::sweep

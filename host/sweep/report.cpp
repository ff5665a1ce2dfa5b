#include "host/sweep/report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "host/base/output_file.h"

namespace shadertwin::sweep {

namespace {

// The targets of all points are the same ones.
std::vector<TimeToTarget> targets_of(const Report& report) {
  for (const Result& result : report.results)
    if (!result.summary.targets.empty()) return result.summary.targets;
  return {};
}

nlohmann::json json_number(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return "never";
  return value;
}

nlohmann::json to_json(const Estimate& estimate) {
  return {{"mean", json_number(estimate.mean)}, {"standard_error", json_number(estimate.error)}};
}

std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return "never";
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) >= 1e-3 || value == 0.0 ? "%.4g" : "%.2e", value);
  return text;
}

// Columns as wide as they need, numbers to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line = row[0] + std::string(widths[0] - row[0].size(), ' ');
    for (std::size_t i = 1; i < row.size(); ++i)
      line += "  " + std::string(widths[i] - row[i].size(), ' ') + row[i];
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

void find_pareto_fronts(Report& report) {
  std::map<std::string, std::vector<Result*>> cases;
  for (Result& result : report.results) cases[case_label(report.axes, result.point)].push_back(&result);
  for (const auto& [name, results] : cases) {
    std::vector<std::vector<Summary>> curves;
    for (const Result* result : results) {
      curves.push_back(result->curve);
      for (Summary& stage : curves.back()) stage.milliseconds = result->summary.milliseconds;
    }
    const std::vector<std::vector<bool>> front = pareto_front(curves);
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i]->front.clear();
      for (std::size_t stage = 0; stage < curves[i].size(); ++stage)
        if (front[i][stage]) results[i]->front.push_back(curves[i][stage]);
    }
  }
}

void write_csv(const Report& report, const std::filesystem::path& file) {
  std::string text;
  for (const Axis& axis : report.axes) text += csv_cell(axis.name) + ',';
  text +=
      "clock,runs,frames,milliseconds,milliseconds_low,milliseconds_high,rmse,relative_mse,relative_mse_"
      "error,"
      "relative_bias2,relative_bias2_error,relative_variance,flip,nan,inf,slope,efficiency";
  const std::vector<TimeToTarget> targets = targets_of(report);
  for (const TimeToTarget& t : targets)
    text += ",seconds_to_" + number_text(t.target) + ",extrapolated_" + number_text(t.target);
  text += ",pareto,status\n";
  for (const Result& result : report.results) {
    for (const std::string& value : result.point) text += csv_cell(value) + ',';
    const Summary& s = result.summary;
    text += (s.gpu ? "gpu," : "cpu,") + std::to_string(s.runs) + ',' + std::to_string(s.frames);
    for (const double value : {s.milliseconds, s.milliseconds_low, s.milliseconds_high, s.rmse.mean,
                               s.relative_mse.mean, s.relative_mse.error, s.relative_bias2.mean,
                               s.relative_bias2.error, s.relative_variance.mean, s.flip.mean})
      text += ',' + number_text(value);
    text += ',' + std::to_string(s.nan) + ',' + std::to_string(s.infinite) + ',' + number_text(s.slope) +
            ',' + number_text(s.efficiency);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const bool known = i < s.targets.size();
      text += ',' + number_text(known ? s.targets[i].seconds : unknown) +
              (known && s.targets[i].extrapolated ? ",yes" : ",no");
    }
    text += std::string(result.pareto() ? ",yes," : ",no,") +
            csv_cell(result.failed.empty() ? "ok" : result.failed) + '\n';
  }
  write_file(file, text);
}

nlohmann::json to_json(const Report& report) {
  nlohmann::json points = nlohmann::json::array();
  for (const Result& result : report.results) {
    nlohmann::json settings = nlohmann::json::object();
    for (std::size_t i = 0; i < report.axes.size(); ++i) settings[report.axes[i].name] = result.point[i];
    const Summary& s = result.summary;
    nlohmann::json point = {{"settings", settings}, {"status", result.failed.empty() ? "ok" : result.failed}};
    if (result.failed.empty()) {
      nlohmann::json stages = nlohmann::json::array();
      for (const Summary& stage : result.curve)
        stages.push_back({{"frames", stage.frames},
                          {"relative_mse", json_number(stage.relative_mse.mean)},
                          {"relative_bias2", json_number(stage.relative_bias2.mean)},
                          {"relative_variance", json_number(stage.relative_variance.mean)}});
      nlohmann::json targets = nlohmann::json::array();
      for (const TimeToTarget& t : s.targets)
        targets.push_back({{"relative_mse", t.target},
                           {"seconds", json_number(t.seconds)},
                           {"extrapolated", t.extrapolated}});
      point.update(
          {{"runs", s.runs},
           {"frames", s.frames},
           {"milliseconds", json_number(s.milliseconds)},
           {"clock", s.gpu ? "gpu" : "cpu"},
           {"milliseconds_range", {json_number(s.milliseconds_low), json_number(s.milliseconds_high)}},
           {"rmse", to_json(s.rmse)},
           {"relative_mse", to_json(s.relative_mse)},
           {"relative_bias2", to_json(s.relative_bias2)},
           {"relative_variance", to_json(s.relative_variance)},
           {"flip", to_json(s.flip)},
           {"nan", s.nan},
           {"inf", s.infinite},
           {"slope", json_number(s.slope)},
           {"efficiency", json_number(s.efficiency)},
           {"time_to_target", targets},
           {"convergence", stages},
           {"pareto", result.pareto()}});
    }
    points.push_back(point);
  }
  return {{"devices", report.devices}, {"points", points}};
}

std::string table(const Report& report) {
  std::vector<std::vector<std::string>> rows;
  const std::vector<TimeToTarget> targets = targets_of(report);
  std::vector<std::string> head = {"", "ms/frame", "spread"};
  if (report.has_reference) {
    head.insert(head.end(), {"relMSE", "+-", "bias^2", "variance", "FLIP", "slope", "efficiency"});
    for (const TimeToTarget& t : targets) head.push_back("s to " + number_text(t.target));
  }
  head.emplace_back("NaN/Inf");
  rows.push_back(head);
  bool extrapolated = false;
  bool curves = false;
  std::string failures;
  for (const Result& result : report.results) {
    const std::string name = label(report.axes, result.point, report.base);
    const Summary& s = result.summary;
    if (!result.failed.empty()) {
      failures += (name.empty() ? "" : name + ": ") + result.failed + '\n';
      continue;
    }
    curves = curves || result.curve.size() > 1;
    const double spread = 50.0 * (s.milliseconds_high - s.milliseconds_low) / s.milliseconds;
    std::vector<std::string> row = {(result.pareto() ? "* " : "  ") + (name.empty() ? "as it is" : name),
                                    short_number(s.milliseconds),
                                    std::isnan(spread) ? "-" : std::to_string(std::lround(spread)) + " %"};
    if (report.has_reference) {
      for (const double value : {s.relative_mse.mean, s.relative_mse.error, s.relative_bias2.mean,
                                 s.relative_variance.mean, s.flip.mean, s.slope, s.efficiency})
        row.push_back(short_number(value));
      for (const TimeToTarget& t : s.targets) {
        const bool guessed = t.extrapolated && std::isfinite(t.seconds);
        extrapolated = extrapolated || guessed;
        row.push_back((guessed ? "~" : "") + short_number(t.seconds));
      }
    }
    row.push_back(std::to_string(s.nan) + "/" + std::to_string(s.infinite));
    rows.push_back(row);
  }
  std::string text = rows.size() > 1 ? aligned(rows) : "";
  if (report.has_reference && rows.size() > 1)
    text += std::string("* no other one is both faster and closer to the reference") +
            (curves ? ", after some number of frames" : "");
  if (extrapolated) text += "; ~ extrapolated by the slope";
  if (report.has_reference && rows.size() > 1) text += '\n';
  return text + failures;
}

}  // namespace shadertwin::sweep

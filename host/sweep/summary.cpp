#include "host/sweep/summary.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace shadertwin::sweep {

namespace {

using Runs = std::vector<Measurement>;

std::vector<double> known(const Runs& runs, const std::function<double(const Measurement&)>& value) {
  std::vector<double> values;
  for (const Measurement& m : runs)
    if (!std::isnan(value(m))) values.push_back(value(m));
  return values;
}

Estimate estimate(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  double mean = 0.0;
  for (const double value : values) mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? unknown : std::sqrt(squares / (n - 1.0) / n)};
}

Runs after(const Runs& runs, int frames) {
  Runs found;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(found),
               [&](const Measurement& m) { return m.frames == frames; });
  return found;
}

// Of measurements after the same number of frames.
Summary means(const Runs& runs) {
  Summary s;
  if (runs.empty()) return s;
  s.frames = runs.front().frames;
  s.gpu = runs.front().gpu;
  std::set<int> numbers;
  for (const Measurement& m : runs) {
    numbers.insert(m.run);
    s.nan += m.nan;
    s.infinite += m.infinite;
  }
  s.runs = static_cast<int>(numbers.size());
  if (const std::vector<double> times = known(runs, [](const Measurement& m) { return m.milliseconds; });
      !times.empty()) {
    s.milliseconds = median(times);
    const auto [low, high] = std::minmax_element(times.begin(), times.end());
    s.milliseconds_low = *low;
    s.milliseconds_high = *high;
  }
  s.rmse = estimate(known(runs, [](const Measurement& m) { return std::sqrt(m.mse); }));
  s.relative_mse = estimate(known(runs, [](const Measurement& m) { return m.relative_mse; }));
  s.relative_bias2 = estimate(known(runs, [](const Measurement& m) { return m.relative_bias2; }));
  s.relative_variance = estimate(known(runs, [](const Measurement& m) { return m.relative_variance; }));
  s.flip = estimate(known(runs, [](const Measurement& m) { return m.flip; }));
  if (s.relative_mse.mean > 0.0) s.efficiency = 1.0 / (s.relative_mse.mean * s.seconds());
  return s;
}

double noise(const Summary& s) {
  return std::isnan(s.relative_variance.mean) ? s.relative_mse.mean : s.relative_variance.mean;
}

// Least squares of log(noise) over log(frames).
double fitted_slope(const std::vector<Summary>& stages) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const Summary& s : stages) {
    if (s.frames < 4 || !(noise(s) > 0.0)) continue;
    const double x = std::log(s.frames);
    const double y = std::log(noise(s));
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return n < 3.0 ? unknown : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TimeToTarget time_to(double target, const std::vector<Summary>& stages, double slope) {
  TimeToTarget result{target};
  const auto seconds = [](double frames, const Summary& s) { return frames * s.milliseconds / 1000.0; };
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const double error = stages[i].relative_mse.mean;
    if (!(error <= target)) continue;
    double frames = stages[i].frames;
    if (i > 0) {  // between two stages both are powers of the frames
      const double before = stages[i - 1].relative_mse.mean;
      const double share = std::log(before / target) / std::log(before / error);
      frames = stages[i - 1].frames * std::pow(frames / stages[i - 1].frames, share);
    }
    result.seconds = seconds(frames, stages.back());
    return result;
  }
  if (stages.empty()) return result;
  const Summary& last = stages.back();
  // What may well be noise is not taken for a bias.
  const Estimate& b = last.relative_bias2;
  const double bias2 = b.mean > 0.0 && !(b.mean < 2.0 * b.error) ? b.mean : 0.0;
  result.extrapolated = true;
  if (bias2 >= target && std::isnan(b.error))
    result.seconds = unknown;  // of one run, nothing tells a bias from noise
  else if (bias2 >= target)
    result.seconds = std::numeric_limits<double>::infinity();
  else if (slope < 0.0)
    result.seconds = seconds(last.frames * std::pow((target - bias2) / noise(last), 1.0 / slope), last);
  return result;
}

}  // namespace

std::vector<Summary> curve(const Runs& runs) {
  std::set<int> frames;
  for (const Measurement& m : runs) frames.insert(m.frames);
  std::vector<Summary> stages;
  for (const int count : frames) stages.push_back(means(after(runs, count)));
  return stages;
}

Summary summarise(const Runs& runs, const std::vector<double>& targets) {
  const std::vector<Summary> stages = curve(runs);
  if (stages.empty()) return {};
  Summary summary = stages.back();
  summary.slope = fitted_slope(stages);
  for (const double target : targets) summary.targets.push_back(time_to(target, stages, summary.slope));
  return summary;
}

std::vector<std::vector<bool>> pareto_front(const std::vector<std::vector<Summary>>& curves) {
  const auto sound = [](const Summary& s) {
    return !std::isnan(s.seconds()) && !std::isnan(s.relative_mse.mean) && s.nan + s.infinite == 0;
  };
  const auto beats = [&](const Summary& a, const Summary& b) {
    return sound(a) && a.seconds() <= b.seconds() && a.relative_mse.mean <= b.relative_mse.mean &&
           (a.seconds() < b.seconds() || a.relative_mse.mean < b.relative_mse.mean);
  };
  std::vector<std::vector<bool>> front;
  for (const std::vector<Summary>& own : curves) {
    front.emplace_back();
    for (const Summary& stage : own)
      front.back().push_back(
          sound(stage) && std::none_of(curves.begin(), curves.end(), [&](const std::vector<Summary>& all) {
            return std::any_of(all.begin(), all.end(), [&](const Summary& s) { return beats(s, stage); });
          }));
  }
  return front;
}

}  // namespace shadertwin::sweep

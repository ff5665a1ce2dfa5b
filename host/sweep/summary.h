// What the runs of a point say together.
#pragma once

#include <string>
#include <vector>

#include "host/sweep/measurement.h"

namespace shadertwin::sweep {

// A mean of several runs with its standard error, which is NaN of one run.
struct Estimate {
  double mean = unknown;
  double error = unknown;
};

// The frames and the time at which the relative MSE falls to `target`.
struct TimeToTarget {
  double target = 0.0;
  double seconds = unknown;   // infinite: never, since the bias alone is larger
  bool extrapolated = false;  // by the slope, beyond the frames that were drawn
};

struct Summary {
  int runs = 0;
  int frames = 0;                 // of the last measurement, which the errors are of
  double milliseconds = unknown;  // a frame: median of the runs, the least and the largest
  bool gpu = false;               // by a GPU's own clock; else the processor time of all threads
  double milliseconds_low = unknown;
  double milliseconds_high = unknown;
  Estimate rmse;
  Estimate relative_mse;
  Estimate relative_bias2;
  Estimate relative_variance;
  Estimate flip;
  std::size_t nan = 0;  // in all runs
  std::size_t infinite = 0;
  // Exponent with which the noise falls with the frames: -1 for independent samples. Fitted to the variance,
  // or to the error where there is no variance, from the fourth frame on.
  double slope = unknown;
  double efficiency = unknown;  // 1 / (relative MSE x seconds), of a picture that isn't exact
  std::vector<TimeToTarget> targets;

  // Of the whole picture.
  double seconds() const { return milliseconds * frames / 1000.0; }
};

// `runs` as RunLog::of() gives them.
Summary summarise(const std::vector<Measurement>& runs, const std::vector<double>& targets);

// Means over the runs for each number of frames, least first.
std::vector<Summary> curve(const std::vector<Measurement>& runs);

// For each stage of each point's curve whether nothing that was measured is both faster and closer to the
// reference. Stages without both figures are not, nor are those with NaN or infinity, whose error is that of
// the other pixels.
std::vector<std::vector<bool>> pareto_front(const std::vector<std::vector<Summary>>& curves);

}  // namespace shadertwin::sweep

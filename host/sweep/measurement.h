// What one run of one point of a sweep measured, and the log that holds the runs, so that a sweep that was
// interrupted goes on where it was.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace shadertwin::sweep {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// After so many frames of a run. What wasn't measured is NaN.
struct Measurement {
  std::string key = {};  // of all that decides the picture: text, frames, size, device, reference
  int run = 0;           // from 0
  int frames = 0;
  double milliseconds = unknown;  // a frame: the median of the run's frames
  bool gpu = false;               // by a GPU's own clock; else the processor time of all threads
  double mse = unknown;
  double relative_mse = unknown;
  double relative_bias2 = unknown;  // of two independent pictures
  double relative_variance = unknown;
  double flip = unknown;
  std::size_t nan = 0;
  std::size_t infinite = 0;
};

class RunLog {
 public:
  // Without a file nothing is kept. What a file holds already is read; a line that broke off is dropped.
  // Throws Error(file) if it can't be read or is something else.
  explicit RunLog(std::filesystem::path file = {});

  // All that is known of a point, in the order of runs and frames.
  std::vector<Measurement> of(const std::string& key) const;
  // Whether a run was measured to its end, after `frames` or more; what broke off counts for nothing.
  bool has(const std::string& key, int run, int frames) const;
  // `settings` says for people what the key stands for. Written at once. Throws Error(file).
  void add(const std::vector<Measurement>& run, const std::string& settings);

 private:
  // In the place of what an earlier attempt at the same run left.
  void put(const Measurement& m);
  // Throws Error(file).
  void need_written() const;

  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<Measurement> all_;
};

// NaN of no values.
double median(std::vector<double> values);

// A number as tables hold it: with all its digits, and nothing for NaN.
std::string number_text(double value);
// A cell of a CSV, in quotes where it needs them (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace shadertwin::sweep

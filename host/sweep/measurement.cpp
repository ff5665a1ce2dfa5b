#include "host/sweep/measurement.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "host/base/error.h"

namespace shadertwin::sweep {

namespace {

constexpr const char* header =
    "key,run,frames,milliseconds,clock,mse,relative_mse,relative_bias2,relative_variance,flip,nan,inf,"
    "settings";

template <typename T>
bool read_number(const std::string& text, T& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
}

bool read_cell(const std::string& text, double& value) {
  value = unknown;
  return text.empty() || read_number(text, value);
}

// False if the line is not whole.
bool read_line(const std::string& line, Measurement& m) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',' && cells.size() < 13)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  if (cells.size() < 13 || cells[0].empty()) return false;
  m.key = cells[0];
  m.gpu = cells[4] == "gpu";
  return read_number(cells[1], m.run) && read_number(cells[2], m.frames) &&
         read_cell(cells[3], m.milliseconds) && read_cell(cells[5], m.mse) &&
         read_cell(cells[6], m.relative_mse) && read_cell(cells[7], m.relative_bias2) &&
         read_cell(cells[8], m.relative_variance) && read_cell(cells[9], m.flip) &&
         read_number(cells[10], m.nan) && read_number(cells[11], m.infinite);
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return unknown;
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

std::string number_text(double value) {
  if (std::isnan(value)) return "";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 7).ptr;
  return {text, end};
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

RunLog::RunLog(std::filesystem::path file) : file_(std::move(file)) {
  if (file_.empty()) return;
  std::error_code failed;
  if (std::filesystem::exists(file_) && !std::filesystem::is_regular_file(file_))
    throw Error(ExitStatus::file, file_.string() + ": is not a file");
  std::uintmax_t whole = 0;  // bytes up to the line that broke off
  if (std::filesystem::exists(file_)) {
    std::ifstream in(file_, std::ios::binary);
    if (!in) throw Error(ExitStatus::file, file_.string() + ": can't be read");
    std::string line;
    std::getline(in, line);
    const bool broke_off = in.eof() && std::string(header).rfind(line, 0) == 0;
    if (line != header && !broke_off)
      throw Error(ExitStatus::file, file_.string() + ": is no log of a sweep; -o another name");
    while (!in.eof()) {
      whole += line.size() + 1;
      Measurement m;
      if (!std::getline(in, line) || in.eof() || !read_line(line, m)) break;
      put(m);
    }
    // Nothing that was measured is written anew: a full disk would lose it.
    std::filesystem::resize_file(file_, whole, failed);
  }
  if (!failed) out_.open(file_, std::ios::binary | std::ios::app);
  if (whole == 0) out_ << header << '\n' << std::flush;
  need_written();
}

void RunLog::need_written() const {
  if (!out_.is_open() || !out_) throw Error(ExitStatus::file, file_.string() + ": can't be written");
}

std::vector<Measurement> RunLog::of(const std::string& key) const {
  std::vector<Measurement> found;
  std::copy_if(all_.begin(), all_.end(), std::back_inserter(found),
               [&](const Measurement& m) { return m.key == key; });
  std::stable_sort(found.begin(), found.end(), [](const Measurement& a, const Measurement& b) {
    return a.run != b.run ? a.run < b.run : a.frames < b.frames;
  });
  return found;
}

bool RunLog::has(const std::string& key, int run, int frames) const {
  return std::any_of(all_.begin(), all_.end(), [&](const Measurement& m) {
    return m.key == key && m.run == run && m.frames >= frames;
  });
}

void RunLog::put(const Measurement& m) {
  std::erase_if(all_, [&](const Measurement& old) {
    return old.key == m.key && old.run == m.run && old.frames == m.frames;
  });
  all_.push_back(m);
}

void RunLog::add(const std::vector<Measurement>& run, const std::string& settings) {
  for (const Measurement& m : run) put(m);
  if (file_.empty()) return;
  std::string lines;
  for (const Measurement& m : run) {
    lines += m.key + ',' + std::to_string(m.run) + ',' + std::to_string(m.frames) + ',' +
             number_text(m.milliseconds) + (m.gpu ? ",gpu" : ",cpu");
    for (const double value : {m.mse, m.relative_mse, m.relative_bias2, m.relative_variance, m.flip})
      lines += ',' + number_text(value);
    lines += ',' + std::to_string(m.nan) + ',' + std::to_string(m.infinite) + ',' + csv_cell(settings) + '\n';
  }
  out_ << lines << std::flush;
  need_written();
}

}  // namespace shadertwin::sweep

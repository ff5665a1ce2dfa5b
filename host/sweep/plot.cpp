#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/base/process.h"
#include "host/sweep/report.h"

namespace shadertwin::sweep {

namespace {

// Colours that people tell apart with any eyesight (Okabe and Ito 2008).
constexpr std::array<const char*, 7> colors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                               "#e69f00", "#56b4e9", "#000000"};

bool drawable(const Summary& s) {
  return s.seconds() > 0.0 && s.relative_mse.mean > 0.0;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

// For a string in double quotes, in which \n begins a line.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? "\\n" : std::string(1, c);
  }
  return result;
}

// Two columns, seconds and relative MSE, as a named block of gnuplot's.
class Blocks {
 public:
  using Rows = std::vector<std::pair<double, double>>;
  std::string add(const Rows& rows, const std::string& name = "") {
    const std::string block = "$d" + std::to_string(count_++);
    text_ += block + " << EOD\n";
    for (const auto& [x, y] : rows)
      text_ +=
          number_text(x) + ' ' + number_text(y) + (name.empty() ? "" : " \"" + escaped(name) + "\"") + '\n';
    text_ += "EOD\n";
    return block;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int count_ = 0;
};

// From each point of the front straight down at its time, then on to the next.
Blocks::Rows front_of(const std::vector<const Result*>& points) {
  Blocks::Rows rows;
  for (const Result* point : points)
    for (const Summary& stage : point->front)
      if (drawable(stage)) rows.emplace_back(stage.seconds(), stage.relative_mse.mean);
  std::sort(rows.begin(), rows.end());
  return rows;
}

Blocks::Rows curve_of(const Result& result) {
  Blocks::Rows rows;
  for (const Summary& stage : result.curve) {
    const double seconds = result.summary.milliseconds * stage.frames / 1000.0;
    if (seconds > 0.0 && stage.relative_mse.mean > 0.0) rows.emplace_back(seconds, stage.relative_mse.mean);
  }
  return rows;
}

// Whether a point differs from the base in no other axis, cases aside.
bool shows(const Report& report, const Point& point, std::size_t axis) {
  for (std::size_t i = 0; i < point.size(); ++i)
    if (i != axis && !report.axes[i].is_case && point[i] != report.base[i]) return false;
  return true;
}

// Names of points, where they are last on the front. Those that would overlap are the lines of one name.
std::vector<std::pair<std::pair<double, double>, std::string>> labels_of(
    const Report& report, const std::vector<const Result*>& points) {
  constexpr double close = 1.15;  // a factor in time and in error: about a line of text on two decades
  std::vector<std::pair<std::pair<double, double>, std::string>> labels;
  for (const Result* point : points) {
    const std::pair place(point->front.back().seconds(), point->front.back().relative_mse.mean);
    const std::string name = variant_label(report.axes, point->point, report.base);
    const auto near = std::find_if(labels.begin(), labels.end(), [&](const auto& label) {
      const auto ratio = [](double a, double b) { return std::max(a / b, b / a); };
      return ratio(label.first.first, place.first) < 2.0 * close &&
             ratio(label.first.second, place.second) < close;
    });
    if (near == labels.end())
      labels.emplace_back(place, name);
    else
      near->second += "\n" + name;
  }
  return labels;
}

// Marks of a logarithmic axis, "" where powers of ten alone are enough.
std::string close_marks(const Blocks::Rows& rows, double Blocks::Rows::value_type::*axis) {
  if (rows.empty()) return "";
  double low = rows.front().*axis;
  double high = low;
  for (const auto& row : rows) {
    low = std::min(low, row.*axis);
    high = std::max(high, row.*axis);
  }
  if (high > 50.0 * low) return "";
  const std::vector<double> digits =
      high > 4.0 * low ? std::vector{1.0, 2.0, 5.0}
                       : std::vector{1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
  std::string marks;
  for (double power = std::floor(std::log10(low)) - 1.0; power <= std::log10(high) + 1.0; ++power)
    for (const double digit : digits)
      marks += (marks.empty() ? "(" : ", ") + number_text(digit * std::pow(10.0, power));
  return marks + ")";
}

std::string panel(const Report& report, const std::vector<const Result*>& points, std::size_t axis,
                  const std::string& title, Blocks& blocks) {
  // In a product every point has some value of the axis; one at a time, only those that differ in it show it.
  const bool all = report.base.empty();
  std::string plots;
  const auto plot = [&](const std::string& part) { plots += (plots.empty() ? "plot " : ", \\\n  ") + part; };
  if (const Blocks::Rows front = front_of(points); front.size() > 1)
    plot(blocks.add(front) +
         " using 1:2 with steps lc rgb '#999999' dt 2 lw 1.5 title 'Pareto front, of filled points'");
  Blocks::Rows drawn = front_of(points);
  std::map<std::string, std::size_t> color;
  for (const Result* point : points) {
    if (!drawable(point->summary)) continue;
    if (!all && !shows(report, point->point, axis)) continue;
    const std::string& value = point->point[axis];
    const bool first = color.count(value) == 0;
    const std::size_t number = color.emplace(value, color.size()).first->second;
    const std::string paint = " lc rgb '" + std::string(colors[number % colors.size()]) + "'";
    const Blocks::Rows way = curve_of(*point);
    drawn.insert(drawn.end(), way.begin(), way.end());
    const std::pair end(point->summary.seconds(), point->summary.relative_mse.mean);
    drawn.push_back(end);
    if (way.size() > 1) plot(blocks.add(way) + " using 1:2 with lines" + paint + " lw 1.2 notitle");
    const Blocks::Rows best = front_of({point});
    if (!best.empty()) plot(blocks.add(best) + " using 1:2 with points pt 7 ps 0.9" + paint + " notitle");
    if (std::find(best.begin(), best.end(), end) == best.end())
      plot(blocks.add({end}) + " using 1:2 with points pt 6 ps 0.9" + paint + " notitle");
    if (first)
      plot("NaN with points pt 7 ps 0.9" + paint + " title " +
           quoted(report.axes[axis].name + " = " + value));
  }
  std::vector<const Result*> named;
  for (const Result* point : points)
    if (point->pareto() && drawable(point->front.back()) && (all || shows(report, point->point, axis)))
      named.push_back(point);
  // Below and to the left of the front there is no other point. Lines of a text are spread around its place.
  for (const auto& [place, name] : labels_of(report, named)) {
    const double down = 0.6 + 0.5 * static_cast<double>(std::count(name.begin(), name.end(), '\n'));
    plot(blocks.add({place}, name) + " using 1:2:3 with labels right offset -0.8,-" + number_text(down) +
         " font ',8' tc rgb '#555555' notitle");
  }
  if (plots.empty()) return "";
  std::string marks;
  for (const auto& [name, axis_of] : {std::pair("xtics", &Blocks::Rows::value_type::first),
                                      std::pair("ytics", &Blocks::Rows::value_type::second)}) {
    const std::string close = close_marks(drawn, axis_of);
    marks += std::string("set ") + name + ' ' + (close.empty() ? "autofreq" : close) + '\n';
  }
  return "set title " + quoted(title) + "\n" + marks + plots + "\n";
}

std::string clock_name(const Report& report) {
  const auto gpu = std::count_if(report.results.begin(), report.results.end(),
                                 [](const Result& r) { return r.summary.gpu; });
  if (gpu == 0) return "processor time";
  return gpu == static_cast<std::ptrdiff_t>(report.results.size()) ? "GPU" : "GPU or processor time";
}

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace

void need_plot_format(const std::filesystem::path& file) {
  if (const std::string extension = extension_of(file); extension != ".svg" && extension != ".png")
    throw Error(ExitStatus::usage, file.string() + ": a plot is an .svg or a .png");
}

void write_plot(const Report& report, const std::string& title, const std::filesystem::path& file) {
  need_plot_format(file);
  const std::filesystem::path gnuplot = find_program({"gnuplot"});
  if (gnuplot.empty()) throw Error(ExitStatus::device, "no plot: gnuplot is not installed");

  std::vector<std::size_t> varied;
  for (std::size_t i = 0; i < report.axes.size(); ++i)
    if (!report.axes[i].is_case && report.axes[i].values.size() > 1) varied.push_back(i);
  if (varied.empty() && !report.axes.empty()) varied.push_back(0);
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Result*>> cases;
  for (const Result& result : report.results) {
    const std::string name = case_label(report.axes, result.point);
    if (cases[name].empty()) order.push_back(name);
    cases[name].push_back(&result);
  }
  Blocks blocks;
  std::string panels;
  for (const std::string& name : order)
    for (const std::size_t axis : varied) {
      const std::string own = panel(report, cases[name], axis,
                                    name + (name.empty() ? "" : ": ") + report.axes[axis].name, blocks);
      panels += own.empty() ? "set multiplot next\n" : own;
    }
  if (panels.find("plot $") == std::string::npos)
    throw Error(ExitStatus::failed, "no plot: no point has both a time and an error");

  const std::size_t columns = order.size() == 1 ? std::min<std::size_t>(varied.size(), 3) : varied.size();
  const std::size_t rows = (order.size() * varied.size() + columns - 1) / columns;
  const std::string size = std::to_string(560 * columns) + "," + std::to_string(440 * rows + 40);
  OutputFile output(file);
  OutputFile script(file.string() + ".gnuplot.txt");
  std::ofstream stream(script.path());
  stream << (extension_of(file) == ".svg"
                 ? "set terminal svg noenhanced font 'sans,11' background 'white' size "
                 : "set terminal pngcairo noenhanced font 'sans,11' size ")
         << size << "\nset output " << quoted(output.path().string()) << '\n'
         << blocks.text()
         << "set logscale xy\nset format xy '%g'\nset autoscale noextend\nset grid lc rgb '#dddddd'\n"
         << "set xlabel 'seconds per picture (" << clock_name(report) << ")'\n"
         << "set ylabel 'relative MSE'\nset key bottom left font ',9'\nset offsets graph 0.3, graph 0.05, "
            "graph 0.08, graph 0.08\n"
         << "set multiplot layout " << rows << ',' << columns << " title " << quoted(title) << '\n'
         << panels << "unset multiplot\n";
  stream.close();
  const ProcessResult run = run_process(gnuplot, {script.path().string()});
  if (run.status != 0 || !std::filesystem::exists(output.path()))
    throw Error(ExitStatus::device, "no plot: gnuplot fails: " + run.output.substr(0, run.output.find('\n')));
  output.commit();
}

}  // namespace shadertwin::sweep

#include "host/sweep/plan.h"

#include <algorithm>

#include "host/base/error.h"

namespace shadertwin::sweep {

namespace {

std::string label_of(const std::vector<Axis>& axes, const Point& point, bool of_cases, const Point& base) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].is_case != of_cases || axes[i].values.size() < 2 || (!base.empty() && point[i] == base[i]))
      continue;
    text += (text.empty() ? "" : " ") + axes[i].name + "=" + point[i];
  }
  return text;
}

}  // namespace

std::vector<std::string> split_values(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    if (c == ',' && depth <= 0)
      values.emplace_back();
    else
      values.back() += c;
  }
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (value->empty()) throw Error(ExitStatus::usage, "a value is empty");
    if (std::find(values.begin(), value, *value) != value)
      throw Error(ExitStatus::usage, *value + " is there twice");
  }
  return values;
}

std::vector<Point> all_combinations(const std::vector<Axis>& axes) {
  std::vector<Point> points(1);
  for (const Axis& axis : axes) {
    std::vector<Point> longer;
    for (const Point& point : points)
      for (const std::string& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

std::vector<Point> one_at_a_time(const std::vector<Axis>& axes, const Point& base) {
  std::vector<Axis> cases = axes;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (!axes[i].is_case) cases[i].values = {base[i]};
  std::vector<Point> points;
  for (const Point& start : all_combinations(cases)) {
    points.push_back(start);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes[i].is_case) continue;
      for (const std::string& value : axes[i].values) {
        if (value == base[i]) continue;
        points.push_back(start);
        points.back()[i] = value;
      }
    }
  }
  return points;
}

std::string case_label(const std::vector<Axis>& axes, const Point& point) {
  return label_of(axes, point, true, {});
}

std::string variant_label(const std::vector<Axis>& axes, const Point& point, const Point& base) {
  const std::string text = label_of(axes, point, false, base);
  return text.empty() && !base.empty() ? "default" : text;
}

std::string label(const std::vector<Axis>& axes, const Point& point, const Point& base) {
  const std::string of_case = case_label(axes, point);
  const std::string variant = variant_label(axes, point, base);
  return of_case + (of_case.empty() || variant.empty() ? "" : " ") + variant;
}

}  // namespace shadertwin::sweep

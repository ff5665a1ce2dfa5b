// What a sweep varies, and the points that come of it.
#pragma once

#include <string>
#include <vector>

namespace shadertwin::sweep {

struct Axis {
  // A macro of the shader, or an option of the same name.
  enum class Kind { define, on, size, init, precise };
  Kind kind = Kind::define;
  std::string name;                 // as columns are called: MASKING, on, size, init, precise
  std::vector<std::string> values;  // one or more, in the order in which they were given
  // Pictures with different values of this axis are different pictures, not better and worse ones: each has a
  // reference of its own.
  bool is_case = false;
};

// A value for each axis, in their order. "" of a macro: it is not set.
using Point = std::vector<std::string>;

// "a,b(1,2),c" is a, b(1,2) and c: commas within brackets separate nothing. Throws Error(usage) for an empty
// value or one that is there twice.
std::vector<std::string> split_values(const std::string& text);

// Every combination; the last axis changes fastest.
std::vector<Point> all_combinations(const std::vector<Axis>& axes);

// For each combination of cases `base`, then all points that differ from it in one axis.
std::vector<Point> one_at_a_time(const std::vector<Axis>& axes, const Point& base);

// "SCENE=1": the cases that have several values, and in which the point is; "" if there are none.
std::string case_label(const std::vector<Axis>& axes, const Point& point);
// The same for all other axes: only those in which the point differs from `base`, if there is one, and
// "default" if it is the same.
std::string variant_label(const std::vector<Axis>& axes, const Point& point, const Point& base = {});
// Both.
std::string label(const std::vector<Axis>& axes, const Point& point, const Point& base = {});

}  // namespace shadertwin::sweep

// Times of frames until they are steady: drivers compile on while a shader is drawn already, and clocks rise
// with work.
#pragma once

#include <cstddef>
#include <vector>

namespace shadertwin::sweep {

class SteadyTimes {
 public:
  // The time of one frame, in milliseconds, in the order of frames.
  void add(double milliseconds) { all_.push_back(milliseconds); }
  std::size_t count() const { return all_.size(); }
  // Whether the last two blocks of frames have medians within a fiftieth of one another.
  bool steady() const;
  // Those of the last two blocks, or of as many frames as there are.
  std::vector<double> last() const;

 private:
  static constexpr std::size_t block = 16;

  std::vector<double> all_;
};

}  // namespace shadertwin::sweep

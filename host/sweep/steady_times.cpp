#include "host/sweep/steady_times.h"

#include <algorithm>
#include <cmath>

#include "host/sweep/measurement.h"

namespace shadertwin::sweep {

bool SteadyTimes::steady() const {
  if (all_.size() < 2 * block) return false;
  const auto end = all_.end();
  const auto middle = end - static_cast<std::ptrdiff_t>(block);
  const double before = median({middle - static_cast<std::ptrdiff_t>(block), middle});
  const double now = median({middle, end});
  return std::abs(now - before) <= 0.02 * std::max(now, before);
}

std::vector<double> SteadyTimes::last() const {
  const std::size_t count = std::min(all_.size(), 2 * block);
  return {all_.end() - static_cast<std::ptrdiff_t>(count), all_.end()};
}

}  // namespace shadertwin::sweep

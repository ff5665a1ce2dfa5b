#include "reference/twin/quad_runner.h"

#include <algorithm>
#include <boost/context/protected_fixedsize_stack.hpp>
#include <climits>

#include "host/base/assert.h"

namespace shadertwin::twin {
namespace {

// Pages that are never touched cost nothing.
constexpr std::size_t usual_stack_bytes = std::size_t{8} << 20;

}  // namespace

void QuadRunner::reserve(std::size_t stack_bytes) {
  if (stack_bytes <= stack_bytes_) return;
  using boost::context::fiber;
  stack_bytes_ = std::max(stack_bytes, usual_stack_bytes);
  for (int i = 0; i < QuadExchange::lanes; ++i) {
    Lane& lane = lanes_[i];
    lane.fiber = fiber(std::allocator_arg, boost::context::protected_fixedsize_stack(stack_bytes_),
                       [this, i, &lane](fiber&& scheduler) -> fiber {
                         lane.scheduler = std::move(scheduler);
                         for (;;) {
                           function_(argument_, i);
                           lane.running = false;
                           lane.scheduler = std::move(lane.scheduler).resume();
                         }
                       });
  }
}

bool QuadRunner::any_running() const {
  return std::any_of(std::begin(lanes_), std::end(lanes_), [](const Lane& lane) { return lane.running; });
}

void QuadRunner::run(void* runner, QuadExchange* exchange, void (*lane)(void* argument, int lane),
                     void* argument) {
  QuadRunner& self = *static_cast<QuadRunner*>(runner);
  self.function_ = lane;
  self.argument_ = argument;
  exchange->runner = runner;
  exchange->wait = [](QuadExchange* waiting, int index) {
    Lane& waits = static_cast<QuadRunner*>(waiting->runner)->lanes_[index];
    waits.scheduler = std::move(waits.scheduler).resume();
  };
  self.run_quad(*exchange);
}

void QuadRunner::run_quad(QuadExchange& exchange) {
  for (int i = 0; i < QuadExchange::lanes; ++i) {
    lanes_[i].running = true;
    resume(i);
  }
  while (any_running()) {
    // Of pixels that have parted, those furthest behind go on until the others are caught up with.
    int place = INT_MAX;
    for (int i = 0; i < QuadExchange::lanes; ++i) {
      if (lanes_[i].running) place = std::min(place, exchange.waiting[i].place);
    }
    exchange.met_lanes = 0;
    for (int i = 0; i < QuadExchange::lanes; ++i) {
      if (!lanes_[i].running || exchange.waiting[i].place != place) continue;
      exchange.met_lanes |= 1U << i;
      exchange.met[i] = exchange.waiting[i];
    }
    const unsigned meeting = exchange.met_lanes;
    SHADERTWIN_ASSERT(meeting != 0);
    for (int i = 0; i < QuadExchange::lanes; ++i) {
      if ((meeting >> i & 1U) != 0) resume(i);
    }
  }
}

}  // namespace shadertwin::twin

// Runs the four pixels of a quad side by side on one thread.
#pragma once

#include <boost/context/fiber.hpp>

#include "reference/twin/abi.h"

namespace shadertwin::twin {

// For twins that run one pixel at a time, in doubles or under check: packets do not need them. Pixels
// exchange values where the shader asks for a derivative or for a level of detail. Fibres leave control flow
// the shader's own. An exchange costs about 40 ns a pixel (640x360, eight exchanges a pixel: 0.33 us a pixel
// on one core).
//
// Four fibres that live as long as the runner, so that a quad costs switches but no stacks. One runner a
// thread.
class QuadRunner {
 public:
  QuadRunner() = default;
  QuadRunner(const QuadRunner&) = delete;
  QuadRunner& operator=(const QuadRunner&) = delete;

  // Gives each lane a stack of so many bytes at least. To be called before run().
  void reserve(std::size_t stack_bytes);

  // A RunQuad; `runner` is a QuadRunner.
  static void run(void* runner, QuadExchange* exchange, void (*lane)(void* argument, int lane),
                  void* argument);

 private:
  struct Lane {
    boost::context::fiber fiber;      // the lane, while the scheduler runs
    boost::context::fiber scheduler;  // the scheduler, while the lane runs
    bool running = false;             // has begun and not yet returned
  };

  void run_quad(QuadExchange& exchange);
  void resume(int lane) { lanes_[lane].fiber = std::move(lanes_[lane].fiber).resume(); }
  bool any_running() const;

  Lane lanes_[QuadExchange::lanes];
  std::size_t stack_bytes_ = 0;
  void (*function_)(void*, int) = nullptr;
  void* argument_ = nullptr;
};

}  // namespace shadertwin::twin

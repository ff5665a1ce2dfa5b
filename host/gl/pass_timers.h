// How long the GPU works on each pass.
#pragma once

#include <array>
#include <vector>

#include "host/gl/context.h"
#include "host/gl/objects.h"

namespace shadertwin::gl {

// Timer queries, several frames deep so that nothing waits for a result. Does nothing on a context without
// EXT_disjoint_timer_query. The context must be current at every call.
class PassTimers {
 public:
  PassTimers(const Context& context, std::size_t passes);

  void begin(std::size_t pass);
  void end(std::size_t pass);
  // Milliseconds that each pass took when it was last measured; -1 if it never was. Empty where the context
  // has no timers.
  const std::vector<double>& milliseconds();

 private:
  static constexpr std::size_t depth = 4;
  struct Timer {
    std::array<QueryObject, depth> queries;
    std::array<bool, depth> waiting{};
    std::size_t next = 0;
    bool running = false;
  };

  void collect(std::size_t pass);

  const Functions& gl_;
  std::vector<Timer> timers_;  // empty without the extension
  std::vector<double> milliseconds_;
};

}  // namespace shadertwin::gl

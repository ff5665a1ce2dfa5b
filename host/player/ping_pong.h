// Which of its targets a pass draws into, and which one its readers get, beyond drawing the passes one after
// the other.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/player/frame.h"
#include "host/project/host_rules.h"

namespace shadertwin {

// A pass has one target, or two that take turns when the previous contents are still needed
// (passes_with_history()): the front one was drawn last, the back one is drawn next.
//
// Three of HostRules change this, as the extension has it (warms_up, swaps_after_frame, reports_first_size).
// Every pass is drawn once before frame 0, to see whether it compiles: a warm-up, which leaves contents that
// earlier passes read in frame 0. The two targets of a pass that reads itself are swapped only when the frame
// is over, so that passes before it read the one that it is about to draw over: that of two frames ago. And
// iChannelResolution gives the size that buffers had at the start, whatever the window's is now.
class PingPong {
 public:
  explicit PingPong(const Project& project);

  // A frame begins. Gives the frame that all passes are to draw before it, from clear targets, if there is a
  // warm-up: it ends with end_warm_up().
  std::optional<Frame> begin(const Frame& frame);
  void end_warm_up() { warming_up_ = false; }
  bool warming_up() const { return warming_up_; }

  // One or two.
  std::size_t targets(std::size_t pass) const { return targets_[pass]; }
  std::size_t front(std::size_t pass) const { return front_[pass]; }
  void set_front(std::size_t pass, std::size_t target) { front_[pass] = target; }
  std::size_t back(std::size_t pass) const { return targets_[pass] == 2 ? 1 - front_[pass] : 0; }
  // The target of `source` that is read while `reader` draws.
  std::size_t read_by(std::size_t reader, std::size_t source) const;
  // The pass has drawn its back target.
  void drawn(std::size_t pass);

  // Width and height of buffers as iChannelResolution gives them.
  glm::ivec2 reported_size() const { return reported_size_; }

 private:
  HostRules rules_;
  std::vector<std::size_t> targets_;
  std::vector<std::size_t> front_;
  bool warming_up_ = false;
  glm::ivec2 size_{0};
  glm::ivec2 reported_size_{0};
};

}  // namespace shadertwin

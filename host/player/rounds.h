// Who draws and reads which picture in a frame, beyond drawing the passes one after the other. Every player
// asks here, so that they can't differ.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "host/player/frame.h"
#include "host/project/host_rules.h"

namespace shadertwin {

// A pass has one picture, or two that take turns when the previous one is still needed
// (passes_with_history()).
//
// Three of HostRules change this, as the extension has it (warms_up, swaps_after_frame, reports_first_size).
// Every pass is drawn once before frame 0,
// to see whether it compiles: a rehearsal, which leaves a picture that earlier passes read in frame 0. The
// two pictures of a pass that reads itself change places only when the frame is over, so that passes before
// it read the one that it is about to draw over: that of two frames ago. And iChannelResolution gives the
// size that buffers had at the start, whatever the window's is now.
class Rounds {
 public:
  explicit Rounds(const Project& project);

  // A frame begins. Gives the frame that all passes are to draw before it, from clear pictures, if there is a
  // rehearsal: it ends with end_rehearsal().
  std::optional<Frame> begin(const Frame& frame);
  void end_rehearsal() { rehearsing_ = false; }
  bool rehearsing() const { return rehearsing_; }

  std::size_t pictures(std::size_t pass) const { return pictures_[pass]; }
  // The picture that was drawn last.
  std::size_t shown(std::size_t pass) const { return shown_[pass]; }
  void show(std::size_t pass, std::size_t picture) { shown_[pass] = picture; }
  // The picture that the pass draws into next.
  std::size_t target(std::size_t pass) const { return pictures_[pass] == 2 ? 1 - shown_[pass] : 0; }
  // The picture of `source` that is read while `reader` draws.
  std::size_t read_by(std::size_t reader, std::size_t source) const;
  // The pass has drawn its target.
  void drawn(std::size_t pass);

  // Width and height of buffers as iChannelResolution gives them.
  glm::ivec2 reported_size() const { return reported_size_; }

 private:
  HostRules rules_;
  std::vector<std::size_t> pictures_;
  std::vector<std::size_t> shown_;
  bool rehearsing_ = false;
  glm::ivec2 size_{0};
  glm::ivec2 reported_size_{0};
};

}  // namespace shadertwin

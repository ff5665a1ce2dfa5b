// Where the window's pictures come from: any Player, one frame at a time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/gl/gl_device.h"
#include "host/player/player.h"
#include "host/view/player_thread.h"
#include "host/view/presenter.h"
#include "host/view/window.h"

namespace shadertwin::view {

// Leaves another context than the window's current only where it says so: in draw(), read() and
// continue_from().
class Stage {
 public:
  virtual ~Stage() = default;

  // Starts a frame; only when ready().
  virtual void draw(const Frame& frame) = 0;
  // Whether the last frame is done, or as good as done, and the next may be drawn. Throws what drawing threw.
  virtual bool ready() = 0;
  // The pass that the window wants.
  virtual void show(int pass) = 0;
  // What a pass holds; without a texture before its first frame, and where only the shown pass is at hand. To
  // be called with the window's context current. The window may look at it until it calls shown().
  virtual ShownTexture picture(int pass) = 0;
  // The window has drawn the picture.
  virtual void shown() {}
  // What a pass holds. Waits for it.
  virtual Image read(int pass) = 0;
  // Milliseconds of every pass, -1 where unknown; empty where nothing is measured.
  virtual std::vector<double> milliseconds() { return {}; }
  virtual std::string description() const = 0;
  // What Player::warnings() says and nobody has printed yet.
  virtual std::vector<std::string> warnings() const { return {}; }
  // Takes over the buffers of the stage before the reload. False if it can't.
  virtual bool continue_from(Stage&) { return false; }
};

// A player in a context of the window: nothing is copied.
std::unique_ptr<Stage> make_shared_stage(Window& window, const Project& project, gl::PlayerOptions options);

// Any other player, in a thread of its own, so that the window answers while it works.
std::unique_ptr<Stage> make_uploading_stage(Window& window, const Project& project,
                                            const MakePlayer& make_player);

}  // namespace shadertwin::view

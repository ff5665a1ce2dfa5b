// Runs a project's passes on the CPU, as C++ compiled from its own GLSL.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/player/player.h"
#include "host/project/project.h"
#include "reference/twin/abi.h"
#include "reference/twin/compiler.h"

namespace shadertwin::twin {

struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
};

// Where a debugger stops: one pixel of one pass in one frame.
struct Breakpoint {
  int pass = 0;
  int frame = 0;
  int x = 0, y = 0;
};

// Whom a checking twin tells what it finds: from any thread, but one pass at a time.
class Observer {
 public:
  virtual ~Observer() = default;
  // A pass begins to draw a frame.
  virtual void begin(int pass, int frame) = 0;
  // As CheckLog in abi.h says.
  virtual void found(int kind, SourceLine at, int x, int y) = 0;
  virtual bool wants_values(int x, int y) = 0;
  virtual void value(int x, int y, SourceLine at, const void* bytes, std::size_t size) = 0;
};

// Whom a twin with shadows tells what it finds (abi.h). Calls come from one thread but for the first two.
class ShadowObserver {
 public:
  virtual ~ShadowObserver() = default;
  // Whether a pixel of the pass that is drawn is told operation by operation, and the telling.
  virtual bool wants_steps(int x, int y) = 0;
  virtual void step(int place, const ShadowNumber* operands, int count, const ShadowNumber& result,
                    double own) = 0;
  // A pass begins to draw a frame. Gives the threshold of picture_error() from which a pixel counts, and
  // whether the pass is the picture that is seen.
  struct Wanted {
    double threshold = 0.0;
    bool is_picture = false;
    bool steps = false;  // whether wants_steps() is to be asked
  };
  virtual Wanted begin(int pass, int frame) = 0;
  // What one thread has noted while it drew, one record of both kinds for each place. Origins count from
  // `first_place`.
  virtual void noted(int pass, std::uint32_t first_place, std::span<const PlaceName> places,
                     std::span<const PlaceRecord> records, std::span<const NumberRecord> numbers) = 0;
  // What the pass has drawn, four numbers a pixel from the lower left; faces one above the other.
  // `moved`: of each pixel, how far it is from what double makes of its own decisions; 0 where they are the
  // float's.
  virtual void drawn(int pass, int frame, glm::ivec2 size, std::span<const ShadowNumber> numbers,
                     std::span<const float> moved) = 0;
};

struct TwinOptions {
  bool double_precision = false;
  Uninitialised uninitialised = Uninitialised::zero;
  // Eight pixels run side by side, to the same bits. Not for doubles, debuggers and observers, which have one
  // at a time.
  bool packets = true;
  // For a debugger: that pass is compiled with -O0 -g and drawn by one thread, and shadertwin_debug_stop() is
  // called before the pixel, which is then drawn alone.
  std::optional<Breakpoint> stop_at;
  std::optional<Rectangle> region;    // of the last pass; what lies outside is left zero
  double timeout = 0;                 // seconds for one frame; 0: none
  Observer* observer = nullptr;       // if given, the twin checks what it does and tells
  ShadowObserver* shadows = nullptr;  // if given, a double stands beside each number, and the twin tells
};

// Translates and compiles every pass, or takes it from the cache, and loads every input. Throws
// Error(shader), Error(file), or Error(device) if there is no C++ compiler. Player::render() throws
// Error(failed) on a timeout.
std::unique_ptr<Player> make_player(const Project& project, const TwinOptions& options = {});

}  // namespace shadertwin::twin

// Does nothing: a place for a debugger to stop at.
extern "C" void shadertwin_debug_stop();

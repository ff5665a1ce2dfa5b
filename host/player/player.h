// What every way of running a project implements. The OpenGL players and the CPU twin meet here and nowhere
// else.
#pragma once

#include <string>

#include "host/image/image.h"
#include "host/player/frame.h"

namespace shadertwin {

class Player {
 public:
  virtual ~Player() = default;

  // Draws every pass once. Buffers keep what they hold between calls; a frame with index 0 starts from
  // cleared buffers. Returns before the work is done where the device allows it.
  virtual void render(const Frame& frame) = 0;

  // What pass `pass` (an index into Project::passes) drew last, float32 RGBA bit for bit. Waits for the
  // device. A cubemap pass gives its six faces below one another, +X at the bottom.
  virtual Image read(int pass) = 0;

  // Waits until everything that was asked for has been drawn.
  virtual void finish() = 0;

  // One line for people: renderer, version, and how fragments run.
  virtual std::string description() const = 0;
};

}  // namespace shadertwin

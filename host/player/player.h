// What every way of running a project implements. The OpenGL players and the CPU twin meet here and nowhere
// else.
#pragma once

#include <string>
#include <vector>

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

  // Block 0, 1, 2 ... of the project's sound pass: sound_block_side x sound_block_side samples, as project.h
  // lays them out. `date` is iDate. What pictures are made of stays as it is; what moves by itself is not
  // bound. Throws Error(shader), and Error(usage) if there is no sound pass.
  virtual Image sound_block(int block, const glm::vec4& date) = 0;

  // Waits until everything that was asked for has been drawn.
  virtual void finish() = 0;

  // One line for people: renderer, version, and how fragments run.
  virtual std::string description() const = 0;

  // One line each: passes that could not run as asked for, inputs that can't be had here.
  virtual std::vector<std::string> warnings() const = 0;
};

}  // namespace shadertwin

// What single pixels compute, statement by statement, and where two runs of them first differ.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/twin/twin_device.h"

namespace shadertwin::check {

struct Pixel {
  int x = 0;
  int y = 0;
};

struct Step {
  SourceLine at;
  bool from_texture = false;
  std::uint64_t hash = 0;  // of the value; 0 for a statement
};

// The steps of each pixel.
using Trace = std::vector<std::vector<Step>>;

// Records the given pixels of one pass in one frame.
class Tracer : public twin::Observer {
 public:
  Tracer(int pass, int frame, std::vector<Pixel> pixels)
      : pass_(pass), frame_(frame), pixels_(std::move(pixels)), trace_(pixels_.size()) {}

  void begin(int pass, int frame) override { active_ = pass == pass_ && frame == frame_; }
  void found(int, SourceLine, int, int) override {}
  bool wants_values(int x, int y) override { return active_ && find(x, y) < pixels_.size(); }
  // Each pixel is drawn by one thread, so each list has one writer.
  void value(int x, int y, SourceLine at, const void* bytes, std::size_t size) override;

  Trace take() { return std::move(trace_); }

 private:
  std::size_t find(int x, int y) const;

  int pass_ = 0;
  int frame_ = 0;
  bool active_ = false;
  std::vector<Pixel> pixels_;
  Trace trace_;
};

// The line of the first step that differs: its value does, or what was decided just before it.
struct Difference {
  SourceLine at;
  bool from_texture = false;
};
Difference first_difference(const std::vector<Step>& a, const std::vector<Step>& b);

}  // namespace shadertwin::check

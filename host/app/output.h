// Where the pictures of `render` go.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "host/image/image.h"
#include "host/player/fixed_clock.h"

namespace shadertwin::app {

// What becomes of the frames.
enum class OutputKind {
  picture,   // the last one: a.png
  pictures,  // a numbered one for every frame: frame_%04d.png
  video,
  sound  // none: the Sound pass is heard
};
// By the name. Throws Error(usage) for one that nothing can be written to.
OutputKind output_kind(const std::string& name);
// The names that there are, for people.
std::string output_help();

struct OutputOptions {
  std::string name;  // as -o gives it
  int crf = -1;      // of a video; below 0: its format's default
  bool full_chroma = false;
  bool quiet = false;  // no warnings on stderr
  bool sound = false;  // there will be some, if the output can hold it
};

class Output {
 public:
  virtual ~Output() = default;
  // Whether every frame's picture is wanted, or only the last one's.
  virtual bool wants_every_frame() const = 0;
  // Pictures of frames that are wanted, in order. Throws Error(file).
  virtual void add(const Image& picture) = 0;
  // Whether add_sound() is to follow every add().
  virtual bool wants_sound() const { return false; }
  // The sound of a frame: left and right in turn, sound_rate of them a second. Throws Error(file).
  virtual void add_sound(std::span<const float>) {}
  // After the last one. Throws Error(file).
  virtual void finish() = 0;
};

// Any kind but sound. Throws Error(usage) for options that the format can't have, Error(file) if it can't be
// written, and Error(device) if this machine lacks an encoder: all of it before the work, not after.
std::unique_ptr<Output> open_output(const OutputOptions& options, glm::ivec2 size, double fps);

}  // namespace shadertwin::app

// Plays a project on OpenGL.
#pragma once

#include <functional>
#include <memory>

#include "host/gl/context.h"
#include "host/player/player.h"
#include "host/project/project.h"
#include "host/text/pipeline.h"

namespace shadertwin::gl {

// How fragments run. A pass that can't run as compute (it uses derivatives, say) falls back to a fragment
// program.
enum class Dispatch {
  automatic,  // compute on NVIDIA GPUs, whose data-centre models have few units for fragments; else fragment
  fragment,
  compute,
};

struct PlayerOptions {
  Dispatch dispatch = Dispatch::automatic;
  bool timers = false;  // measure every pass on the GPU
  // What to compile for a pass, in the order in which it is tried. One that comes later means a warning.
  std::function<std::vector<PassSource>(const Project&, const Pass&)> sources = driver_sources;
};

class GlPlayer : public Player {
 public:
  // Compiles every pass and loads every input. Throws Error(shader), Error(file), or Error(device) if the
  // context has no float targets.
  static std::unique_ptr<GlPlayer> create(std::unique_ptr<Context> context, const Project& project,
                                          const PlayerOptions& options = {});

  // The texture (GL_TEXTURE_2D, RGBA32F) that holds what pass `pass` drew last.
  virtual GLuint texture(int pass) const = 0;
  virtual Context& context() = 0;
  // Takes over what the passes of the same name and kind hold in `earlier`, so that a changed shader goes on
  // from there. Both contexts must share their objects.
  virtual void continue_from(GlPlayer& earlier) = 0;
  // What each pass took on the GPU when last measured, -1 before; empty without PlayerOptions::timers or
  // timer queries.
  virtual std::vector<double> milliseconds() = 0;
};

}  // namespace shadertwin::gl

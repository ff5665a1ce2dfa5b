// What crosses the border between shadertwin and a compiled twin: plain data and C functions.
#pragma once

#include <cstddef>

namespace shadertwin::twin {

// Changes whenever a twin compiled before the change can't be run any more.
constexpr int abi_version = 4;

// The value of a uniform, by name.
struct UniformValue {
  enum class Kind { float32, int32, sampler };

  const char* name = nullptr;
  Kind kind = Kind::float32;
  const void* data = nullptr;  // count numbers in the order of GLSL, or the sampler object
  int count = 1;
};

// How the four pixels of a 2x2 square hand one another their values, for derivatives. Pixel i of a quad lies
// at (x + i % 2, y + i / 2).
struct QuadExchange {
  static constexpr int lanes = 4;
  static constexpr std::size_t max_bytes = 4 * sizeof(double);

  struct Slot {
    alignas(32) unsigned char value[max_bytes];
    int place;  // where in the text; pixels that wait at the same place meet there
  };

  Slot waiting[lanes];
  Slot met[lanes];
  unsigned met_lanes = 0;  // bit i: pixel i is one of those that met
  // Called by a pixel that has filled its slot of `waiting`. Comes back when the pixels that meet here are in
  // `met`.
  void (*wait)(QuadExchange* exchange, int lane) = nullptr;
  void* runner = nullptr;  // for wait
};

// Runs `lane(argument, i)` for i in 0..3 side by side, until all have returned.
using RunQuad = void (*)(void* runner, QuadExchange* exchange, void (*lane)(void* argument, int lane),
                         void* argument);

// A line of the shader: an index into Project::files, -1 for the host's text, and the line from 1.
struct CheckPlace {
  int file = -1;
  int line = 0;
};

// Whom a twin compiled with SHADERTWIN_CHECK tells what it finds, from any thread.
struct CheckLog {
  void* user = nullptr;
  // A glsl::Check, at most once for each pixel, kind and place.
  void (*found)(void* user, int kind, CheckPlace place, int x, int y) = nullptr;
  // Whether value() is to be called for what the pixel computes.
  bool (*wants_values)(void* user, int x, int y) = nullptr;
  // A statement (no bytes), a value that it assigned or returned, or one read from a texture (no file).
  void (*value)(void* user, int x, int y, CheckPlace place, const void* bytes, std::size_t size) = nullptr;
};

// A rectangle of pixels to draw.
struct Request {
  const UniformValue* uniforms = nullptr;
  int uniform_count = 0;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // pixels [x0, x1) x [y0, y1)
  void* pixels = nullptr;        // RGBA of pixel (x0, y0), four Floats; a discarded pixel stays as it is
  std::ptrdiff_t row_pitch = 0;  // Floats from one row to the next
  bool quads = false;            // run 2x2 pixels side by side
  RunQuad run_quad = nullptr;
  void* quad_runner = nullptr;
  const CheckLog* log = nullptr;  // of a checking twin
  const bool* stop = nullptr;     // when set, the twin returns soon and leaves pixels undrawn
};

// Of Request::stop, which another thread sets. <atomic> would double the time that compiling a twin's headers
// takes.
inline bool is_set(const bool& flag) {
  return __atomic_load_n(&flag, __ATOMIC_RELAXED);
}

struct Description {
  int abi = abi_version;
  bool double_precision = false;
  bool uses_derivatives = false;
  bool uses_implicit_lod = false;
  // Of all variables, and of the arrays and structures that calls and constructors give.
  std::size_t value_bytes = 0;
};

// The functions that a twin exports.
using DescribeFunction = void (*)(Description*);
using RenderFunction = void (*)(const Request*);
constexpr const char* describe_name = "shadertwin_describe";
constexpr const char* render_name = "shadertwin_render";

}  // namespace shadertwin::twin

// What crosses the border between shadertwin and a compiled twin: plain data and C functions.
#pragma once

#include <cstddef>
#include <cstdint>

namespace shadertwin::twin {

// Changes whenever a twin compiled before the change can't be run any more.
constexpr int abi_version = 5;

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
  static constexpr std::size_t max_bytes = 4 * 2 * sizeof(double);  // four shadows

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

// --- Shadows: twins compiled with SHADERTWIN_SHADOW --------------------------

// One number of a pixel that such a twin draws: glsl::Shadow.
struct ShadowNumber {
  float value;
  std::uint32_t origin;  // 1 + the operation's place, counted through all passes; 0: none
  double exact;
};

// An operation, a comparison or an assignment in the shader's text. Place 0 is none.
struct PlaceName {
  int file = -1;  // as CheckPlace has it
  int line = 0;
  const char* text = "";  // as the shader has it; empty for an assignment or a return
};

struct PixelPlace {
  int frame = 0;
  int x = 0;
  int y = 0;
};

// Threads draw in any order; of equals the first pixel counts.
inline bool is_before(const PixelPlace& a, const PixelPlace& b) {
  if (a.frame != b.frame) return a.frame < b.frame;
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}

// What happened at an operation or a comparison.
struct PlaceRecord {
  static constexpr int most_operands = 3;

  // Operations whose own error is notable, and the worst of them. `loss` is a glsl::Loss.
  std::uint64_t losses = 0;
  double own = -1.0;  // its own error, relative to its result
  int loss = 0;
  PixelPlace lost_at;
  int operand_count = 0;
  ShadowNumber operands[most_operands]{};
  ShadowNumber result{};

  // Pixels in which float and double decide differently here, the first such decision, and how far the
  // picture is at most from what double makes of its own decisions.
  std::uint64_t parted = 0;
  PixelPlace parted_at;
  ShadowNumber sides[2]{};
  bool is_number = false;   // one number that becomes an integer, not two that are compared
  std::uint64_t tried = 0;  // of `parted`: pixels that were run again, as double decides
  std::uint64_t moved = 0;  // of `tried`: pixels in which that is more than ShadowLog::threshold
  double moved_by = 0.0;
  PixelPlace moved_at;
};

// The numbers that are assigned or returned at a place. Small, since every pixel writes into it many times.
struct NumberRecord {
  std::uint64_t numbers = 0;
  double error_sum = 0.0;  // of relative errors
  double error = 0.0;      // the largest
  PixelPlace error_at;
  std::uint64_t not_finite = 0;  // whose error is infinite or no number: not in the sum
};

// Whom a twin with shadows tells what it finds.
struct ShadowLog {
  // Of this thread, one of both for each place.
  PlaceRecord* records = nullptr;
  NumberRecord* numbers = nullptr;
  std::uint32_t first_place = 0;  // of the pass, counted through all passes
  int frame = 0;
  float* moved = nullptr;  // as Request::pixels, one number a pixel: PlaceRecord::moved_by of that pixel
  double threshold = 0.0;  // of picture_error()
  bool is_picture = false;
  // One pixel is told operation by operation; null: none is.
  bool (*wants_steps)(void* user, int x, int y) = nullptr;
  void (*step)(void* user, int place, const ShadowNumber* operands, int count, const ShadowNumber* result,
               double own) = nullptr;
  void* user = nullptr;
};

// How far a number of a pixel is from what it should be. In the picture that is seen, between 0 and 1 as
// screens show it; in a buffer, relative to numbers above 1. 1 at most; also where just one is no number.
inline double picture_error(bool is_picture, double value, double exact) {
  if (value != value || exact != exact) return value != value && exact != exact ? 0.0 : 1.0;
  const auto shown = [](double x) { return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x; };
  const auto size = [](double x) { return x < 0.0 ? -x : x; };
  if (is_picture) return size(shown(value) - shown(exact));
  if (value == exact) return 0.0;
  const double largest = size(value) > size(exact) ? size(value) : size(exact);
  const double error = size(value - exact) / (largest > 1.0 ? largest : 1.0);
  return error <= 1.0 ? error : 1.0;
}

// --- Drawing ----------------------------------------------------------------

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
  const ShadowLog* shadow_log = nullptr;
  const bool* stop = nullptr;  // when set, the twin returns soon and leaves pixels undrawn
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
  const PlaceName* places = nullptr;  // of a twin with shadows
  int place_count = 0;
};

// The functions that a twin exports.
using DescribeFunction = void (*)(Description*);
using RenderFunction = void (*)(const Request*);
constexpr const char* describe_name = "shadertwin_describe";
constexpr const char* render_name = "shadertwin_render";

}  // namespace shadertwin::twin

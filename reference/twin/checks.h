// What a twin that is compiled with SHADERTWIN_CHECK notes while it draws a pixel: undefined operations with
// their place in the shader, where NaN and infinities first appear, how often loops turn, and, for pixels
// that are traced, every value. Names end in two underscores, which the emitter gives to no name of a
// shader's.
#pragma once

#ifdef SHADERTWIN_CHECK
#include <vector>
#endif

#include "reference/glsl/probes.h"
#include "reference/twin/abi.h"

namespace shadertwin::twin {

#ifndef SHADERTWIN_CHECK

struct Checks {};

#else

class Checks {
 public:
  // A function begins: what follows its call stands on the caller's line again.
  class Caller__ {
   public:
    explicit Caller__(Checks& checks) : checks__(checks), place__(checks.place__) {}
    ~Caller__() { checks__.mark__(place__.file, place__.line); }
    Caller__(const Caller__&) = delete;
    Caller__& operator=(const Caller__&) = delete;

   private:
    Checks& checks__;
    CheckPlace place__;
  };

  // The pixel (x, y) begins; no log for one that is only computed for its neighbours.
  void start__(const CheckLog* log, int x, int y) {
    log__ = log;
    x__ = x;
    y__ = y;
    place__ = {};
    has_nan__ = has_infinity__ = false;
    rounds__ = 0;
    noted__.clear();
    traced__ = log != nullptr && log->wants_values(log->user, x, y);
    resume__();
  }
  // This invocation runs again on its thread.
  void resume__() { running__ = this; }

  void mark__(int file, int line) {
    place__ = {file, line};
    if (traced__) [[unlikely]]
      log__->value(log__->user, x__, y__, place__, nullptr, 0);
  }

  // A loop begins a round. True if it has to end: far beyond what any device runs.
  [[nodiscard]] bool round__() {
    constexpr unsigned llvmpipe_rounds = 65534;
    constexpr unsigned last_round = 1u << 20;
    if (++rounds__ == llvmpipe_rounds + 1) note__(glsl::Check::loop_beyond_cap);
    return rounds__ > last_round;
  }

  // A value that is assigned or returned.
  template <class T>
  void watch__(const T& value) {
    trace__(value);
    if constexpr (is_float__<T>) {
      if (!has_nan__ && glsl::detail::has_nan(value)) [[unlikely]] {
        has_nan__ = true;
        note__(glsl::Check::first_nan);
      }
      if (!has_infinity__ && glsl::detail::has_infinity(value)) [[unlikely]] {
        has_infinity__ = true;
        note__(glsl::Check::first_infinity);
      }
    }
  }
  template <class T>
  T watched__(const T& value) {
    watch__(value);
    return value;
  }

  // A value from a texture: what is wrong with it first appeared elsewhere.
  template <class T>
  T sampled__(const T& value) {
    if (traced__) [[unlikely]]
      log__->value(log__->user, x__, y__, {}, &value, sizeof value);
    if constexpr (is_float__<T>) {
      has_nan__ |= glsl::detail::has_nan(value);
      has_infinity__ |= glsl::detail::has_infinity(value);
    }
    return value;
  }

  void note__(glsl::Check kind) {
    if (log__ == nullptr) return;
    for (const Noted__& noted : noted__) {
      if (noted.kind == kind && noted.place.line == place__.line && noted.place.file == place__.file) return;
    }
    noted__.push_back({kind, place__});
    log__->found(log__->user, static_cast<int>(kind), place__, x__, y__);
  }

  static Checks* current__() { return running__; }

 private:
  struct Noted__ {
    glsl::Check kind;
    CheckPlace place;
  };

  template <class T>
  static constexpr bool is_float__ = std::is_same_v<typename glsl::detail::Shape<T>::Scalar, glsl::Float>;

  template <class T>
  void trace__(const T& value) {
    if (traced__) [[unlikely]]
      log__->value(log__->user, x__, y__, place__, &value, sizeof value);
  }

  static inline thread_local Checks* running__ = nullptr;

  const CheckLog* log__ = nullptr;
  int x__ = 0;
  int y__ = 0;
  CheckPlace place__;
  bool traced__ = false;
  bool has_nan__ = false;
  bool has_infinity__ = false;
  unsigned rounds__ = 0;
  std::vector<Noted__> noted__;
};

#endif

}  // namespace shadertwin::twin

#ifdef SHADERTWIN_CHECK
namespace shadertwin::glsl {
void report(Check kind) {
  if (twin::Checks* checks = twin::Checks::current__()) checks->note__(kind);
}
}  // namespace shadertwin::glsl
#endif

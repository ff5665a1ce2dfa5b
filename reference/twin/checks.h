// What a twin that is compiled with SHADERTWIN_CHECK notes while it draws a pixel: undefined operations with
// their place in the shader, where NaN and infinities first appear, how often loops turn, and, for pixels that
// are traced, every value. Names end in two underscores, which no shader's name does.
#pragma once

#include <vector>

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
    explicit Caller__(Checks& checks) : checks_(checks), place_(checks.place_) {}
    ~Caller__() { checks_.mark__(place_.file, place_.line); }
    Caller__(const Caller__&) = delete;
    Caller__& operator=(const Caller__&) = delete;

   private:
    Checks& checks_;
    CheckPlace place_;
  };

  // The pixel (x, y) begins; no log for one that is only computed for its neighbours.
  void start__(const CheckLog* log, int x, int y) {
    log_ = log;
    x_ = x;
    y_ = y;
    place_ = {};
    has_nan_ = has_infinity_ = false;
    rounds_ = 0;
    noted_.clear();
    traced_ = log != nullptr && log->wants_values(log->user, x, y);
    resume__();
  }
  // This invocation runs again on its thread.
  void resume__() { current_ = this; }

  void mark__(int file, int line) {
    place_ = {file, line};
    if (traced_) [[unlikely]]
      log_->value(log_->user, x_, y_, place_, nullptr, 0);
  }

  // A loop begins a round. True if it has to end: far beyond what any device runs.
  [[nodiscard]] bool round__() {
    constexpr unsigned llvmpipe_rounds = 65534;
    constexpr unsigned last_round = 1u << 20;
    if (++rounds_ == llvmpipe_rounds + 1) note__(glsl::Check::loop_beyond_cap);
    return rounds_ > last_round;
  }

  // A value that is assigned or returned.
  template <class T>
  void watch__(const T& value) {
    trace(value);
    if constexpr (is_float<T>) {
      if (!has_nan_ && glsl::detail::has_nan(value)) [[unlikely]] {
        has_nan_ = true;
        note__(glsl::Check::nan_born);
      }
      if (!has_infinity_ && glsl::detail::has_infinity(value)) [[unlikely]] {
        has_infinity_ = true;
        note__(glsl::Check::infinity_born);
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
    if (traced_) [[unlikely]]
      log_->value(log_->user, x_, y_, {}, &value, sizeof value);
    if constexpr (is_float<T>) {
      has_nan_ |= glsl::detail::has_nan(value);
      has_infinity_ |= glsl::detail::has_infinity(value);
    }
    return value;
  }

  void note__(glsl::Check kind) {
    if (log_ == nullptr) return;
    for (const Noted& noted : noted_) {
      if (noted.kind == kind && noted.place.line == place_.line && noted.place.file == place_.file) return;
    }
    noted_.push_back({kind, place_});
    log_->found(log_->user, static_cast<int>(kind), place_, x_, y_);
  }

  static Checks* current__() { return current_; }

 private:
  struct Noted {
    glsl::Check kind;
    CheckPlace place;
  };

  template <class T>
  static constexpr bool is_float = std::is_same_v<typename glsl::detail::Shape<T>::Scalar, glsl::Float>;

  template <class T>
  void trace(const T& value) {
    if (traced_) [[unlikely]]
      log_->value(log_->user, x_, y_, place_, &value, sizeof value);
  }

  static inline thread_local Checks* current_ = nullptr;

  const CheckLog* log_ = nullptr;
  int x_ = 0;
  int y_ = 0;
  CheckPlace place_;
  bool traced_ = false;
  bool has_nan_ = false;
  bool has_infinity_ = false;
  unsigned rounds_ = 0;
  std::vector<Noted> noted_;
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

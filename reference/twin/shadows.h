// What a twin that is compiled with SHADERTWIN_SHADOW notes while it draws a pixel: where digits are lost,
// where float and double decide differently, and how exact the numbers are that each line assigns. Names end
// in two underscores, which the emitter gives to no name of a shader's.
#pragma once

#ifdef SHADERTWIN_SHADOW
#include <algorithm>
#include <vector>
#endif

#include "reference/glsl/builtins.h"
#include "reference/twin/abi.h"

namespace shadertwin::twin {

#ifndef SHADERTWIN_SHADOW

struct Shadows {};

#else

class Shadows {
 public:
  using Shadow = glsl::Shadow;

  // The pixel (x, y) begins. With `follows_double` control flow is that of the doubles, and nothing is noted;
  // nor is it without a log, for a pixel that is only computed for its neighbours.
  void start__(const ShadowLog* log, int x, int y, bool follows_double) {
    log__ = log;
    pixel__ = {log != nullptr ? log->frame : 0, x, y};
    notes__ = log != nullptr && !follows_double;
    follows_double__ = follows_double;
    place__ = 0;
    rounds__ = 0;
    if (!follows_double) {
      parted__.clear();
      decides__ = false;
    }
    told__ = notes__ && log->wants_steps != nullptr && log->wants_steps(log->user, x, y);
    if (told__ && !glsl::telling__) glsl::telling__ = true;
    resume__();
  }
  // This invocation runs again on its thread.
  void resume__() { running__ = this; }

  // --- What emitted code calls ---

  // The operands have been evaluated: what follows happens at `place`.
  void at__(int place) { place__ = place; }
  template <class T>
  T at__(int place, const T& operand) {
    place__ = place;
    return operand;
  }

#define SHADERTWIN_OPERATION(name, op)                             \
  template <class A, class B>                                      \
  SHADERTWIN_INLINE auto name(int place, const A& a, const B& b) { \
    place__ = place;                                               \
    return a op b;                                                 \
  }
  SHADERTWIN_OPERATION(add__, +)
  SHADERTWIN_OPERATION(subtract__, -)
  SHADERTWIN_OPERATION(multiply__, *)
  SHADERTWIN_OPERATION(divide__, /)
  SHADERTWIN_OPERATION(less__, <)
  SHADERTWIN_OPERATION(greater__, >)
  SHADERTWIN_OPERATION(less_equal__, <=)
  SHADERTWIN_OPERATION(greater_equal__, >=)
  SHADERTWIN_OPERATION(equal__, ==)
  SHADERTWIN_OPERATION(not_equal__, !=)
#undef SHADERTWIN_OPERATION

  template <class T, class... Argument>
  SHADERTWIN_INLINE T make_at__(int place, const Argument&... arguments) {
    place__ = place;
    return glsl::make<T>(arguments...);
  }

  // A built-in function: sin_at__(place, x).
#define SHADERTWIN_FUNCTION_AT(f)                                       \
  template <class... Argument>                                          \
  SHADERTWIN_INLINE auto f##_at__(int place, Argument&&... arguments) { \
    place__ = place;                                                    \
    return glsl::f(arguments...);                                       \
  }
#define SHADERTWIN_BUILTIN(op, f, ...) SHADERTWIN_FUNCTION_AT(f)
#define SHADERTWIN_HELPER(f, ...)
#include "reference/glsl/builtins.def"
  SHADERTWIN_FUNCTION_AT(mix_strict)
  SHADERTWIN_FUNCTION_AT(atan_strict)
#undef SHADERTWIN_FUNCTION_AT

  // Numbers that are assigned or returned.
  template <class T>
  SHADERTWIN_INLINE void watch__(int place, const T& value) {
    if constexpr (std::is_same_v<typename glsl::detail::Shape<T>::Scalar, Shadow>) {
      if (notes__) measure__(log__->numbers[place], value);
    }
  }
  template <class T>
  SHADERTWIN_INLINE T watched__(int place, const T& value) {
    watch__(place, value);
    return value;
  }

  // A loop begins a round. True if it has to end: far beyond what any device runs.
  [[nodiscard]] bool round__() {
    constexpr unsigned last_round = 1U << 20;
    return ++rounds__ > last_round;
  }

  // --- What shadow.h calls ---

  std::uint32_t lost__(glsl::Loss loss, const Shadow* operands, int count, const Shadow& result, double own) {
    if (log__ == nullptr) return 0;
    if (notes__) {
      PlaceRecord& record = log__->records[place__];
      ++record.losses;
      if (own > record.own || (own == record.own && is_before(pixel__, record.lost_at))) {
        record.own = own;
        record.loss = static_cast<int>(loss);
        record.lost_at = pixel__;
        record.operand_count = count;
        for (int i = 0; i < count; ++i) record.operands[i] = plain__(operands[i]);
        record.result = plain__(result);
      }
    }
    return log__->first_place + static_cast<std::uint32_t>(place__) + 1;
  }

  void tell__(const Shadow* operands, int count, const Shadow& result, double own) {
    if (!told__) return;
    ShadowNumber plain[PlaceRecord::most_operands];
    for (int i = 0; i < count; ++i) plain[i] = plain__(operands[i]);
    const ShadowNumber plain_result = plain__(result);
    log__->step(log__->user, place__, plain, count, &plain_result, own);
  }

  template <class T>
  T parts__(T of_float, T of_double, const Shadow& a, const Shadow* b, bool decides = true) {
    if (follows_double__) return of_double;
    decides__ = decides__ || decides;
    if (std::find(parted__.begin(), parted__.end(), place__) == parted__.end()) {
      parted__.push_back(place__);
      if (notes__) {
        PlaceRecord& record = log__->records[place__];
        if (++record.parted == 1 || is_before(pixel__, record.parted_at)) {
          record.parted_at = pixel__;
          record.sides[0] = plain__(a);
          record.sides[1] = plain__(b != nullptr ? *b : a);
          record.is_number = b == nullptr;
        }
      }
    }
    return of_float;
  }

  // Whether the pixel that has run is to run again, as double decides. Bits part in most pixels of a shader
  // that reads any: there every fourth pixel has its turn.
  bool has_parted__() const {
    const bool has_turn = (pixel__.x + 2 * pixel__.y + pixel__.frame) % 4 == 0;
    return decides__ || (has_turn && !parted__.empty());
  }
  // The pixel was drawn as one, and double makes the other of it.
  void moved__(double by) {
    if (log__ == nullptr) return;
    for (const int place : parted__) {
      PlaceRecord& record = log__->records[place];
      ++record.tried;
      if (by >= log__->threshold) ++record.moved;
      if (by > record.moved_by || (by == record.moved_by && is_before(pixel__, record.moved_at))) {
        record.moved_by = by;
        record.moved_at = pixel__;
      }
    }
  }

  static Shadows* current__() {
    return running__;
  }

 private:
  static ShadowNumber plain__(const Shadow& x) {
    return {x.value, x.origin, x.exact};
  }
  template <class T>
  SHADERTWIN_INLINE void measure__(NumberRecord& record, const T& value) {
    if constexpr (std::is_same_v<T, Shadow>) {
      measure_number__(record, value);
    } else {
      for (int i = 0; i < value.length(); ++i) measure__(record, value[i]);
    }
  }
  SHADERTWIN_INLINE void measure_number__(NumberRecord& record, const Shadow& x) {
    ++record.numbers;
    const double error = glsl::distance_of(x);
    if (error == 0.0) return;
    const double size = glsl::larger_half_of(x);
    const bool is_small = error <= size * glsl::notable;
    const double share = is_small ? error / size : glsl::share_of(glsl::error_of(x), x);
    if (share > 1.0) [[unlikely]] {
      ++record.not_finite;
      return;
    }
    record.error_sum += share;
    if (share >= record.error) [[unlikely]]
      worst__(record, share);
  }
  [[gnu::noinline]] void worst__(NumberRecord& record, double share) {
    if (share == record.error && !is_before(pixel__, record.error_at)) return;
    record.error = share;
    record.error_at = pixel__;
  }

  static inline thread_local Shadows* running__ = nullptr;

  const ShadowLog* log__ = nullptr;
  PixelPlace pixel__;
  int place__ = 0;
  bool notes__ = false;
  bool follows_double__ = false;
  bool told__ = false;
  bool decides__ = false;  // something else than bits has parted
  unsigned rounds__ = 0;
  std::vector<int> parted__;  // places, in the order in which they were met
};

#endif

}  // namespace shadertwin::twin

#ifdef SHADERTWIN_SHADOW
namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {
inline std::uint32_t lost__(Loss loss, const Shadow* operands, int count, const Shadow& result, double own) {
  return twin::Shadows::current__()->lost__(loss, operands, count, result, own);
}
inline bool parted__(bool of_float, const Shadow& a, const Shadow& b) {
  return twin::Shadows::current__()->parts__(of_float, !of_float, a, &b);
}
inline int parted__(int of_float, int of_double, const Shadow& x) {
  return twin::Shadows::current__()->parts__(of_float, of_double, x, nullptr);
}
inline std::uint32_t parted__(std::uint32_t of_float, std::uint32_t of_double, const Shadow& x) {
  return twin::Shadows::current__()->parts__(of_float, of_double, x, nullptr);
}
inline std::uint32_t parted_bits__(std::uint32_t of_float, std::uint32_t of_double, const Shadow& x) {
  return twin::Shadows::current__()->parts__(of_float, of_double, x, nullptr, false);
}
inline void tell__(const Shadow* operands, int count, const Shadow& result, double own) {
  twin::Shadows::current__()->tell__(operands, count, result, own);
}
}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION
#endif

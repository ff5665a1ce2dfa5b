// What emitted code says more where a shader is checked: operations that C++ writes as operators, and values
// that are no numbers.
#pragma once

#include "reference/glsl/builtins.h"

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

namespace detail {

template <class T, class Test>
SHADERTWIN_INLINE bool any_component(const T& x, Test test) {
  if constexpr (Shape<T>::matrix) {
    for (int c = 0; c < Shape<T>::columns; ++c) {
      if (any_component(x[c], test)) return true;
    }
    return false;
  } else if constexpr (Shape<T>::rows > 1) {
    for (int i = 0; i < Shape<T>::rows; ++i) {
      if (test(x[i])) return true;
    }
    return false;
  } else {
    return test(x);
  }
}

template <class T>
SHADERTWIN_INLINE bool has_nan(const T& x) {
  return any_component(x, [](auto v) { return v != v; });
}
template <class T>
SHADERTWIN_INLINE bool has_infinity(const T& x) {
  return any_component(x, [](auto v) { return std::fabs(static_cast<double>(v)) == infinity; });
}

}  // namespace detail

// a / b of floats: reports each division by zero.
template <class A, class B>
SHADERTWIN_INLINE auto checked_divide(const A& a, const B& b) {
  SHADERTWIN_PROBE(detail::any_component(b, [](auto v) { return v == 0; }), float_division_by_zero);
  return a / b;
}

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION

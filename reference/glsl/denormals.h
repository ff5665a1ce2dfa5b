// Denormals as llvmpipe's fragment threads treat them.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace shadertwin::glsl {

// While it lives, arithmetic of this thread takes denormal operands for zero and gives zero for a denormal
// result. Moves, abs and negation keep them. Without effect on processors other than x86.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | flush_to_zero | denormals_are_zero);
  }
  ~FlushDenormals() {
    _mm_setcsr(before_);
  }
#else
  FlushDenormals() {}
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
 private:
  static constexpr unsigned flush_to_zero = 0x8000;
  static constexpr unsigned denormals_are_zero = 0x0040;
  unsigned before_;
#endif
};

}  // namespace shadertwin::glsl

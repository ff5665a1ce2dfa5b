// What a shader does not write.
#pragma once

#include <cstring>

#include "reference/glsl/types.h"

namespace shadertwin::glsl {

// A variable that GLSL leaves undefined. Zero, as WebGL has it; a pattern that shows where it is used when
// SHADERTWIN_PATTERN is defined.
template <class T>
SHADERTWIN_INLINE void unwritten(T& variable) {
#ifdef SHADERTWIN_PATTERN
  std::memset(static_cast<void*>(&variable), 0xfe, sizeof variable);
#else
  variable = T{};
#endif
}

}  // namespace shadertwin::glsl

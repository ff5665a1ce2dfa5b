// Inputs for the built-ins, made of the pixel's position by integers alone, so that a shader on any device
// and C++ here get the same bits without a texture between them.
#pragma once

#include <string>

#include "reference/glsl/glsl.h"

namespace shadertwin::glsl {

// What the components of an argument are drawn from.
struct Domain {
  enum class Kind {
    bits,      // any of the 2^32 patterns; one in sixteen is an extreme (zeros, denormals, infinities, ends)
    scale,     // log-uniform: magnitude in [2^low, 2^high), both signs
    positive,  // log-uniform: [2^low, 2^high)
    range,     // uniform in [-2^high, 2^high), in steps of 2^(high - 23)
    unit,      // uniform in [0, 1), in steps of 2^-24
  };
  Kind kind = Kind::bits;
  int low = 0;
  int high = 0;

  std::string text() const;
};

// The four components of argument `index` (from 0) at pixel (x, y).
vec4 input_at(const Domain& domain, uint x, uint y, uint index);

// The same as GLSL: functions input_bits, input_scale ... and how `domain` calls them.
std::string input_functions();
std::string input_call(const Domain& domain, int index);

}  // namespace shadertwin::glsl

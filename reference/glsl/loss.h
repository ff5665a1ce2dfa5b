// The ways in which float arithmetic loses digits, as `accuracy` tells them apart.
#pragma once

namespace shadertwin::glsl {

enum class Loss : int {
  cancellation,  // a sum or difference far smaller than its operands, whose last digits are rounded
  absorption,    // a sum that drops most of its smaller term
  rounding,      // no operation of its own loses much, but the roundings of many add up
  conditioning,  // a built-in whose result changes far more than its argument: tan() near pi/2
  coarse,        // a built-in that the device computes to fewer digits than a float has
  jump,          // floor(), fract(), step() ...: float and double stand on two sides of a step
  underflow,     // a result too small for a float
  overflow,      // a result too large for a float
  count
};

// The word that stands in front of a finding.
constexpr const char* name_of(Loss loss) {
  switch (loss) {
    case Loss::cancellation:
      return "cancellation";
    case Loss::absorption:
      return "absorption";
    case Loss::rounding:
      return "rounding";
    case Loss::conditioning:
      return "conditioning";
    case Loss::coarse:
      return "coarse";
    case Loss::jump:
      return "jump";
    case Loss::underflow:
      return "underflow";
    case Loss::overflow:
      return "overflow";
    case Loss::count:
      break;
  }
  return "";
}

}  // namespace shadertwin::glsl

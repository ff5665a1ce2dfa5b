// How wrong a picture is, measured against a reference that is taken to be right.
#pragma once

#include <cstddef>

#include "host/image/image.h"

namespace shadertwin {

// Keeps the relative error of black pixels finite: (x - r)^2 / (r^2 + this).
constexpr double relative_floor = 1e-2;

// Over the red, green and blue values of all pixels; alpha is not looked at. A value that isn't finite, in
// the picture or in the reference, is counted and left out of the means. All means are 0 when no value is
// left.
struct PictureError {
  std::size_t values = 0;  // that the means are over
  std::size_t nan = 0;     // of the picture
  std::size_t infinite = 0;
  double mse = 0.0;           // mean of (x - r)^2
  double relative_mse = 0.0;  // mean of (x - r)^2 / (r^2 + relative_floor)
};

// The pictures must have one size.
PictureError picture_error(const Image& picture, const Image& reference);

// The error of a random estimate, told apart by two independent pictures a and b of it: noise, that more
// samples remove, is different in both; bias is the same. With the errors e_a and e_b, E[e_a e_b] is the
// square of the bias, and E[(a - b)^2] / 2 the variance. Both are unbiased estimates and relative, as
// relative_mse is: their expectations add up to its own. The bias may therefore come out below 0, if noise
// hides it.
struct ErrorParts {
  double relative_bias2 = 0.0;
  double relative_variance = 0.0;
};

// The reference may be an estimate, too: if `reference_a` and `reference_b` are independent, their own noise
// adds nothing. Errors are relative to their mean. The pictures must have one size.
ErrorParts error_parts(const Image& a, const Image& b, const Image& reference_a, const Image& reference_b);

}  // namespace shadertwin

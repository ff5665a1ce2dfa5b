// The difference that people see between two pictures when they flip from one to the other.
#pragma once

#include "host/image/image.h"

namespace shadertwin {

// Pixels a degree of the visual field: of a 0.7 m wide screen of 3840 pixels seen from 0.7 m.
constexpr double flip_pixels_per_degree = 67.0;

// FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator
// for Alternating Images", HPG) of what a canvas shows: the mean over all pixels, from 0, equal, to 1. Values
// are clamped to [0, 1] and taken as sRGB; NaN is 0. The pictures must have one size.
double flip(const Image& picture, const Image& reference, double pixels_per_degree = flip_pixels_per_degree);

// The same for every pixel, as a grey picture.
Image flip_map(const Image& picture, const Image& reference,
               double pixels_per_degree = flip_pixels_per_degree);

}  // namespace shadertwin

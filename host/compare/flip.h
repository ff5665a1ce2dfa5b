// The difference that people see between two pictures when they flip from one to the other.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/image/image.h"

namespace shadertwin {

// Pixels a degree of the visual field: of a 0.7 m wide screen of 3840 pixels seen from 0.7 m.
constexpr double flip_pixels_per_degree = 67.0;

// FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator
// for Alternating Images", HPG) of what a canvas shows, from 0, equal, to 1. Values are clamped to [0, 1] and
// taken as sRGB; NaN is 0. The pictures must have the reference's size.
class Flip {
 public:
  explicit Flip(const Image& reference, double pixels_per_degree = flip_pixels_per_degree);

  // Over all pixels.
  double mean(const Image& picture) const;
  // Every pixel's, as a grey picture.
  Image map(const Image& picture) const;

 private:
  // What an eye makes of a picture.
  struct Seen {
    int width = 0;
    int height = 0;
    std::vector<glm::dvec3> colors;    // filtered as the eye does, CIE L*a*b* with the Hunt effect
    std::vector<glm::dvec2> features;  // strength of edges, and of points
  };
  static Seen see(const Image& image, double pixels_per_degree);
  std::vector<double> differences(const Image& picture) const;

  double pixels_per_degree_;
  Seen reference_;
};

}  // namespace shadertwin

// How large the picture is drawn for a window, and where the window's places are in it.
#pragma once

#include <array>

#include "host/view/window.h"

namespace shadertwin::view {

class Canvas {
 public:
  explicit Canvas(const Window& window) : window_(window) {}

  // The next of the scales: 1, 1/2, 1/4, 2 pixels of the picture along a pixel of the window.
  void rescale() { scale_ = (scale_ + 1) % scales.size(); }
  const char* scale() const { return scales[scale_].name; }  // as a title has it

  // Of the picture, in pixels.
  glm::ivec2 size() const {
    const Scale& scale = scales[scale_];
    return glm::max(window_.pixels() * scale.times / scale.divided_by, glm::ivec2(1));
  }
  // From window units, y down, to pixels of the picture, y up.
  glm::dvec2 to_picture(glm::dvec2 position) const {
    const glm::dvec2 scaled = position / window_size() * glm::dvec2(size());
    return {scaled.x, size().y - scaled.y};
  }
  // From window units, y down, to 0 to 1 across the window, y up.
  glm::dvec2 across(glm::dvec2 position) const {
    const glm::dvec2 unit = (position + 0.5) / window_size();
    return {unit.x, 1.0 - unit.y};
  }

 private:
  struct Scale {
    int times;
    int divided_by;
    const char* name;
  };
  static constexpr std::array<Scale, 4> scales = {
      {{1, 1, ""}, {1, 2, " (1/2)"}, {1, 4, " (1/4)"}, {2, 1, " (2)"}}};

  glm::dvec2 window_size() const { return glm::max(window_.size(), glm::ivec2(1)); }

  const Window& window_;
  std::size_t scale_ = 0;
};

}  // namespace shadertwin::view

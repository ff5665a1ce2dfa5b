// A picture of one colour.
#pragma once

#include "host/image/image.h"

namespace shadertwin {

inline Image flat_image(int width, int height, float r, float g, float b) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = r;
    image.rgba[i + 1] = g;
    image.rgba[i + 2] = b;
    image.rgba[i + 3] = 1.0F;
  }
  return image;
}

}  // namespace shadertwin

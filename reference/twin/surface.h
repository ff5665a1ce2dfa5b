// Textures of the twin: those that passes sample, and those that they draw into.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "host/image/image.h"
#include "reference/glsl/texture_image.h"

namespace shadertwin::twin {

class Surface {
 public:
  Surface(Texture texels, bool mipmaps);
  // To be drawn into, `faces` of one size below one another. It has no pixels yet. With `doubles` it is drawn
  // in double and sampled in float.
  Surface(int faces, bool mipmaps, bool doubles);

  const Texture& texture() const { return texture_; }
  // What samplers look at. Another one whenever the texels have changed.
  const glsl::TextureImage* image() const { return image_.get(); }

  // New texels of the old size and format.
  void upload(const Texture& texels);

  // The rest is for surfaces to be drawn into. Makes them zero but, if `keep`, for what they held from the
  // lower left corner up; more than one face is not kept.
  void resize(glm::ivec2 size, bool keep);
  void clear();
  glm::ivec2 size() const { return {texture_.width, texture_.height}; }
  int faces() const { return texture_.faces; }
  // Four numbers a pixel: doubles if they were asked for, else floats. `pixel` counts from the lower left of
  // the first face.
  void* pixels(std::size_t pixel);
  // Makes what was drawn visible to samplers.
  void finish_drawing();
  // The faces stand one above the other.
  Image read() const;

 private:
  Texture texture_;
  std::vector<double> doubles_;
  bool has_doubles_ = false;
  bool mipmaps_;
  std::unique_ptr<glsl::TextureImage> image_;
};

}  // namespace shadertwin::twin

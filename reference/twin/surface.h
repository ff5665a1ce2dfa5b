// Textures of the twin: those that passes sample, and those that they draw into.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "host/image/image.h"
#include "reference/glsl/texture_image.h"
#include "reference/twin/abi.h"

namespace shadertwin::twin {

// What passes compute with.
enum class Numbers { floats, doubles, shadows };

class Surface {
 public:
  Surface(Texture texels, bool mipmaps);
  // To be drawn into, `faces` of one size below one another. It has no pixels yet. It is sampled in float,
  // whatever is drawn, but shadows find their doubles again.
  Surface(int faces, bool mipmaps, Numbers numbers);

  const Texture& texture() const { return texture_; }
  // What samplers look at. Another one whenever the texels have changed.
  const glsl::TextureImage* image() const { return image_.get(); }
  // What shadows look at beside it.
  glsl::ShadowViews shadow_views() const;

  // New texels of the old size and format.
  void upload(const Texture& texels);

  // The rest is for surfaces to be drawn into. Makes them zero but, if `keep`, for what they held from the
  // lower left corner up; more than one face is not kept.
  void resize(glm::ivec2 size, bool keep);
  void clear();
  glm::ivec2 size() const { return {texture_.width, texture_.height}; }
  int faces() const { return texture_.faces; }
  // Four numbers a pixel, of the kind that was asked for. `pixel` counts from the lower left of the first
  // face.
  void* pixels(std::size_t pixel);
  const std::vector<ShadowNumber>& shadows() const { return shadows_; }
  // Makes what was drawn visible to samplers.
  void finish_drawing();
  // The faces stand one above the other.
  Image read() const;

 private:
  void finish_companions();

  Texture texture_;
  Numbers numbers_ = Numbers::floats;
  std::vector<double> doubles_;
  std::vector<ShadowNumber> shadows_;
  bool mipmaps_;
  bool halves_ = false;  // a cube that is drawn holds half floats
  std::unique_ptr<glsl::TextureImage> image_;
  // Of shadows: the exact texels rounded to float, what that leaves, and origins.
  struct Companion {
    Texture texture;
    std::unique_ptr<glsl::TextureImage> image;
  };
  std::array<Companion, 3> companions_;
};

}  // namespace shadertwin::twin

// Textures on the host's side of a twin: a picture with its mipmaps, and how it becomes a shader's sampler.
#pragma once

#include <vector>

#include "host/image/image.h"
#include "host/project/project.h"
#include "reference/glsl/sampler.h"

namespace shadertwin::glsl {

// A picture and, where asked for, its chain of mipmaps down to one texel, each level made of the one before
// as glGenerateMipmap does on llvmpipe.
class TextureImage {
 public:
  // Refers to texture's texels: `texture` must outlive this and not change. `halves`: each is one that half
  // floats hold, and so are those of mipmaps.
  TextureImage(const Texture& texture, bool mipmaps, bool halves = false);

  const TextureView& view() const { return view_; }

 private:
  void add_mipmaps(int faces, bool halves);

  TextureView view_;
  std::vector<std::vector<std::byte>> mipmaps_;
};

// What a shader gets. A null image is an unbound channel: (0, 0, 0, 1) is read. The image must outlive the
// sampler.
sampler2D bind2d(const TextureImage* image, const Sampler& sampler);
sampler3D bind3d(const TextureImage* image, const Sampler& sampler);
samplerCube bindcube(const TextureImage* image, const Sampler& sampler);

}  // namespace shadertwin::glsl

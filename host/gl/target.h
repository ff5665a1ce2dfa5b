// What a pass draws into.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "host/gl/context.h"
#include "host/gl/objects.h"
#include "host/image/image.h"

namespace shadertwin::gl {

// One picture, or several of one size: a texture each, with a framebuffer to draw into it. Everything needs
// the context to be current, and leaves other framebuffers and textures bound.
class Target {
 public:
  // `kind`: GL_TEXTURE_2D or GL_TEXTURE_CUBE_MAP. The pictures have no size yet. With `mipmaps` they have
  // room for smaller levels.
  Target(const Context& context, GLenum kind, std::size_t pictures, bool mipmaps);

  GLenum kind() const { return kind_; }
  int faces() const { return kind_ == GL_TEXTURE_CUBE_MAP ? 6 : 1; }
  glm::ivec2 size() const { return size_; }
  GLuint texture(std::size_t picture) const { return pictures_[picture].texture.name(); }

  // Makes new pictures, transparent black but, if `keep`, for what the old ones held from the lower left
  // corner up. Throws Error(device) if the device can't draw into float32 RGBA.
  void resize(glm::ivec2 size, bool keep);
  // Makes all of them transparent black.
  void clear();
  // Takes over a picture of the same kind and size. It may belong to another context in the share group.
  void copy(const Target& source, std::size_t from, std::size_t to);
  // Makes a face of a picture what is drawn to and read from.
  void bind(std::size_t picture, int face) const;
  // Computes the smaller levels, if there is room for them.
  void make_mipmaps(std::size_t picture) const;
  // The faces stand one above the other. Throws Error(device).
  Image read(std::size_t picture) const;

 private:
  struct Picture {
    TextureObject texture;
    FramebufferObject framebuffer;
  };

  GLenum face_target(int face) const {
    return kind_ == GL_TEXTURE_CUBE_MAP ? static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : kind_;
  }
  Picture make_picture(glm::ivec2 size) const;

  const Functions* gl_;
  const DeviceInfo* device_;
  GLenum kind_;
  bool mipmaps_;
  glm::ivec2 size_{0};
  std::vector<Picture> pictures_;
};

}  // namespace shadertwin::gl

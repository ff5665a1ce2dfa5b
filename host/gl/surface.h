// Textures on the GPU: those that passes sample, and those that they draw into.
#pragma once

#include <glm/glm.hpp>

#include "host/gl/context.h"
#include "host/gl/objects.h"
#include "host/image/image.h"

namespace shadertwin::gl {

// Everything needs the context to be current, and leaves other framebuffers and textures bound.
class Surface {
 public:
  // Holds the texels: GL_TEXTURE_2D, _CUBE_MAP or _3D by their faces and depth.
  Surface(const Context& context, const Texture& texels, bool mipmaps);
  // To be drawn into. It has no size yet.
  Surface(const Context& context, bool cube, bool mipmaps);

  GLenum kind() const { return kind_; }
  int faces() const { return kind_ == GL_TEXTURE_CUBE_MAP ? 6 : 1; }
  glm::ivec2 size() const { return size_; }
  GLuint texture() const { return texture_.name(); }

  // New texels of the old size and format, for GL_TEXTURE_2D.
  void upload(const Texture& texels);

  // The rest is for surfaces to be drawn into. Makes a new texture, transparent black but, if `keep`, for
  // what the old one held from the lower left corner up. Throws Error(device) if the device can't draw into
  // float32 RGBA.
  void resize(glm::ivec2 size, bool keep);
  // Makes all faces transparent black.
  void clear();
  // Takes over the texels of a surface of the same kind and size. It may belong to another context in the
  // share group.
  void copy(const Surface& source);
  // Makes a face what is drawn to and read from.
  void bind(int face) const;
  // Computes the smaller levels, if there is room for them.
  void make_mipmaps() const;
  // The faces stand one above the other. Throws Error(device).
  Image read() const;

 private:
  GLenum face_target(int face) const {
    return kind_ == GL_TEXTURE_CUBE_MAP ? static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : kind_;
  }

  const Functions* gl_;
  const DeviceInfo* device_;
  GLenum kind_;
  bool mipmaps_;
  glm::ivec2 size_{0};
  TextureObject texture_;
  FramebufferObject framebuffer_;
};

}  // namespace shadertwin::gl

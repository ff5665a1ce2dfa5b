// Puts a pass's picture on the window, and looks at single pixels of it.
#pragma once

#include <glm/glm.hpp>

#include "host/gl/context.h"
#include "host/gl/objects.h"

namespace shadertwin::view {

// A texture in the window's share group. Cubemaps have GL_TEXTURE_CUBE_MAP as their target, and the size of a
// face.
struct ShownTexture {
  GLenum target = GL_TEXTURE_2D;
  GLuint texture = 0;
  glm::ivec2 size{0};
};

// A texel of a picture; `face` of a cubemap, else 0.
struct PixelPlace {
  glm::ivec2 at{0};
  int face = 0;
};

// Where the point (0 to 1 across the window, y up) lies in a picture. Faces of a cubemap stand in two rows of
// three, -Y +Z -Z below +X -X +Y.
PixelPlace place_in(const ShownTexture& picture, glm::dvec2 point);

class Presenter {
 public:
  // `context` must outlive this, and be current at every call.
  explicit Presenter(const gl::Context& context);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  // Fills a framebuffer of `window` pixels as a browser's canvas would, clamped and opaque. A larger picture
  // is averaged. `paint`: not-a-number is magenta, infinities are yellow (+) and cyan (-).
  void draw(const ShownTexture& picture, glm::ivec2 window, bool paint);
  void clear(glm::ivec2 window);

  // One pixel, bit for bit. Waits for the device.
  glm::vec4 pixel(const ShownTexture& picture, const PixelPlace& place);

 private:
  GLuint compile(const char* sampler, const char* fetch);

  const gl::Functions& gl_;
  gl::VertexArrayObject vertex_array_;
  gl::FramebufferObject framebuffer_;
  GLuint flat_ = 0;
  GLuint cube_ = 0;
};

}  // namespace shadertwin::view

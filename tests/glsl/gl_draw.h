// Draws one fragment shader on an OpenGL device, with a texture if need be.
#pragma once

#include <memory>

#include "host/gl/context.h"
#include "host/gl/textures.h"
#include "tests/glsl/measure.h"

namespace shadertwin::glsl {

class GlDraw {
 public:
  // `device`: as gl::open_context takes it. Throws Error(device).
  explicit GlDraw(const std::string& device);

  // The pixels of `shader`, which has `void mainImage(out vec4 fragColor, in vec2 fragCoord)`. Throws
  // std::runtime_error with the compiler's log.
  Image operator()(const std::string& shader, int width, int height);

  // What `uniform sampler... s` of later shaders reads.
  void bind(const Texture& texture, const shadertwin::Sampler& sampler, bool mipmaps);

  const gl::DeviceInfo& info() const { return context_->info(); }

 private:
  std::unique_ptr<gl::Context> context_;
  gl::TextureObject texture_;
  gl::SamplerObject sampler_;
  GLenum target_ = GL_TEXTURE_2D;
};

}  // namespace shadertwin::glsl

// Pictures and sampler settings on the GPU.
#pragma once

#include <glm/glm.hpp>

#include "host/gl/objects.h"
#include "host/image/image.h"
#include "host/project/project.h"

namespace shadertwin::gl {

// A texture and the target it is bound to.
struct BoundTexture {
  GLenum target = GL_TEXTURE_2D;
  GLuint name = 0;
};

// GL_TEXTURE_2D, _CUBE_MAP or _3D by the texture's faces and depth, with the whole mipmap chain if `mipmaps`.
TextureObject upload(const Functions& gl, const Texture& texture, bool mipmaps);
GLenum texture_target(const Texture& texture);

// Empty storage for what a pass draws: size x size x 6 in RGBA16F, as shadertoy.com keeps
// a cubemap, or width x height in RGBA32F.
TextureObject make_target(const Functions& gl, GLenum target, glm::ivec2 size, bool mipmaps);

// What an unbound channel reads: one texel (0, 0, 0, alpha). WebGL gives an incomplete texture the alpha 1.
TextureObject make_unbound(const Functions& gl, GLenum target, std::uint8_t alpha = 255);

SamplerObject make_sampler(const Functions& gl, const Sampler& sampler);

bool uses_mipmaps(MinFilter filter);

}  // namespace shadertwin::gl

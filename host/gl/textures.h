// Pictures and sampler settings on the GPU.
#pragma once

#include <glm/glm.hpp>

#include "host/gl/objects.h"
#include "host/image/image.h"
#include "host/project/project.h"

namespace shadertwin::gl {

// GL_TEXTURE_2D, _CUBE_MAP or _3D by the texture's faces and depth, with the whole mipmap chain if `mipmaps`.
TextureObject upload(const Functions& gl, const Texture& texture, bool mipmaps);
GLenum texture_target(const Texture& texture);

// Empty storage for what a pass draws: size x size x 6 in RGBA16F, as shadertoy.com keeps
// a cubemap, or width x height in RGBA32F.
TextureObject make_target(const Functions& gl, GLenum target, glm::ivec2 size, bool mipmaps);

SamplerObject make_sampler(const Functions& gl, const Sampler& sampler);

}  // namespace shadertwin::gl

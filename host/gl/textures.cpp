#include "host/gl/textures.h"

#include <algorithm>
#include <array>
#include <bit>

#include "host/base/assert.h"

namespace shadertwin::gl {

namespace {

GLsizei mip_levels(int width, int height, int depth) {
  return static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max({width, height, depth}))));
}

// Without this GL treats a texture whose chain is not complete as unbound when a sampler asks for mipmaps.
void limit_levels(const Functions& gl, GLenum target, GLsizei levels) {
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

}  // namespace

GLenum texture_target(const Texture& texture) {
  if (texture.faces == 6) return GL_TEXTURE_CUBE_MAP;
  return texture.is_volume ? GL_TEXTURE_3D : GL_TEXTURE_2D;
}

TextureObject upload(const Functions& gl, const Texture& texture, bool mipmaps) {
  TextureObject object(gl);
  const GLenum target = texture_target(texture);
  const GLenum format = texture.format == Texture::Format::rgba8 ? GL_RGBA8 : GL_RGBA32F;
  const GLenum type = texture.format == Texture::Format::rgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
  const GLsizei levels = mipmaps ? mip_levels(texture.width, texture.height, texture.depth) : 1;
  gl.BindTexture(target, object.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::size_t face_bytes = texture.texel_bytes() * texture.width * texture.height * texture.depth;
  SHADERTWIN_ASSERT_EQ(texture.data.size(), face_bytes * static_cast<std::size_t>(texture.faces));
  if (target == GL_TEXTURE_3D) {
    gl.TexStorage3D(target, levels, format, texture.width, texture.height, texture.depth);
    gl.TexSubImage3D(target, 0, 0, 0, 0, texture.width, texture.height, texture.depth, GL_RGBA, type,
                     texture.data.data());
  } else {
    gl.TexStorage2D(target, levels, format, texture.width, texture.height);
    for (int face = 0; face < texture.faces; ++face)
      gl.TexSubImage2D(target == GL_TEXTURE_2D ? GL_TEXTURE_2D
                                               : static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face),
                       0, 0, 0, texture.width, texture.height, GL_RGBA, type,
                       texture.data.data() + face_bytes * static_cast<std::size_t>(face));
  }
  limit_levels(gl, target, levels);
  if (levels > 1) gl.GenerateMipmap(target);
  return object;
}

TextureObject make_target(const Functions& gl, GLenum target, glm::ivec2 size, bool mipmaps) {
  TextureObject object(gl);
  const GLsizei levels = mipmaps ? mip_levels(size.x, size.y, 1) : 1;
  gl.BindTexture(target, object.name());
  gl.TexStorage2D(target, levels, target == GL_TEXTURE_CUBE_MAP ? GL_RGBA16F : GL_RGBA32F, size.x, size.y);
  limit_levels(gl, target, levels);
  return object;
}

SamplerObject make_sampler(const Functions& gl, const Sampler& sampler) {
  static constexpr std::array<GLint, 6> min_filters = {
      GL_NEAREST,
      GL_LINEAR,
      GL_NEAREST_MIPMAP_NEAREST,
      GL_NEAREST_MIPMAP_LINEAR,
      GL_LINEAR_MIPMAP_NEAREST,
      GL_LINEAR_MIPMAP_LINEAR,
  };
  static constexpr std::array<GLint, 3> wraps = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
  static_assert(
      min_filters[static_cast<std::size_t>(MinFilter::nearest_mipmap_linear)] == GL_NEAREST_MIPMAP_LINEAR &&
      min_filters[static_cast<std::size_t>(MinFilter::linear_mipmap_linear)] == GL_LINEAR_MIPMAP_LINEAR);
  static_assert(wraps[static_cast<std::size_t>(Wrap::clamp)] == GL_CLAMP_TO_EDGE &&
                wraps[static_cast<std::size_t>(Wrap::mirror)] == GL_MIRRORED_REPEAT);
  SamplerObject object(gl);
  const auto set = [&](GLenum what, GLint value) { gl.SamplerParameteri(object.name(), what, value); };
  const GLint wrap = wraps[static_cast<std::size_t>(sampler.wrap)];
  set(GL_TEXTURE_MIN_FILTER, min_filters[static_cast<std::size_t>(sampler.min)]);
  set(GL_TEXTURE_MAG_FILTER, sampler.mag == MagFilter::nearest ? GL_NEAREST : GL_LINEAR);
  set(GL_TEXTURE_WRAP_S, wrap);
  set(GL_TEXTURE_WRAP_T, wrap);
  set(GL_TEXTURE_WRAP_R, wrap);
  return object;
}

}  // namespace shadertwin::gl

#include "host/gl/surface.h"

#include <array>
#include <utility>

#include "host/base/error.h"
#include "host/gl/textures.h"

namespace shadertwin::gl {

namespace {

constexpr std::array<GLfloat, 4> transparent_black{};

}  // namespace

Surface::Surface(const Context& context, const Texture& texels, bool mipmaps)
    : gl_(&context.functions()),
      device_(&context.info()),
      kind_(texture_target(texels)),
      mipmaps_(mipmaps),
      size_(texels.width, texels.height),
      texture_(gl::upload(*gl_, texels, mipmaps)) {}

Surface::Surface(const Context& context, bool cube, bool mipmaps)
    : gl_(&context.functions()),
      device_(&context.info()),
      kind_(cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D),
      mipmaps_(mipmaps) {}

void Surface::upload(const Texture& texels) {
  gl_->BindTexture(kind_, texture_.name());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexSubImage2D(kind_, 0, 0, 0, size_.x, size_.y, GL_RGBA,
                     texels.format == Texture::Format::rgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                     texels.data.data());
  make_mipmaps();
}

void Surface::resize(glm::ivec2 size, bool keep) {
  const glm::ivec2 common = glm::min(size, std::exchange(size_, size));
  const TextureObject old_texture = std::exchange(texture_, make_target(*gl_, kind_, size, mipmaps_));
  const FramebufferObject old_framebuffer = std::exchange(framebuffer_, FramebufferObject(*gl_));
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(0), texture_.name(), 0);
  if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ExitStatus::device, device_->name + " can't draw into float32 RGBA");
  clear();
  if (!keep || common.x == 0) return;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, old_framebuffer.name());
  gl_->BlitFramebuffer(0, 0, common.x, common.y, 0, 0, common.x, common.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  make_mipmaps();
}

void Surface::clear() {
  if (size_.x == 0) return;
  for (int face = 0; face < faces(); ++face) {
    bind(face);
    gl_->ClearBufferfv(GL_COLOR, 0, transparent_black.data());
  }
  make_mipmaps();
}

void Surface::copy(const Surface& source) {
  const FramebufferObject reader(*gl_);  // framebuffers, unlike textures, are not shared
  for (int face = 0; face < faces(); ++face) {
    bind(face);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, reader.name());
    gl_->FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(face), source.texture(),
                              0);
    gl_->BlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  make_mipmaps();
}

void Surface::bind(int face) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  if (faces() == 6)
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(face), texture(), 0);
}

void Surface::make_mipmaps() const {
  if (!mipmaps_) return;
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(kind_, texture());
  gl_->GenerateMipmap(kind_);
}

Image Surface::read() const {
  Image image(size_.x, size_.y * faces());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int face = 0; face < faces(); ++face) {
    bind(face);
    gl_->ReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, image.at(0, face * size_.y));
  }
  if (gl_->GetError() != GL_NO_ERROR)
    throw Error(ExitStatus::device, device_->name + ": the picture can't be read back");
  return image;
}

}  // namespace shadertwin::gl

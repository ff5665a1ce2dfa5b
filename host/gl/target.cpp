#include "host/gl/target.h"

#include <array>
#include <utility>

#include "host/base/error.h"
#include "host/gl/textures.h"

namespace shadertwin::gl {

namespace {

constexpr std::array<GLfloat, 4> transparent_black{};

}  // namespace

Target::Target(const Context& context, GLenum kind, std::size_t pictures, bool mipmaps)
    : gl_(&context.functions()),
      device_(&context.info()),
      kind_(kind),
      mipmaps_(mipmaps),
      pictures_(pictures) {}

Target::Picture Target::make_picture(glm::ivec2 size) const {
  Picture picture{make_target(*gl_, kind_, size, mipmaps_), FramebufferObject(*gl_)};
  gl_->BindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(0), picture.texture.name(), 0);
  if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ExitStatus::device, device_->name + " can't draw into float32 RGBA");
  return picture;
}

void Target::resize(glm::ivec2 size, bool keep) {
  const glm::ivec2 old_size = std::exchange(size_, size);
  std::vector<Picture> old(pictures_.size());
  old.swap(pictures_);
  for (Picture& picture : pictures_) picture = make_picture(size);
  clear();
  if (!keep || old_size.x == 0) return;
  const glm::ivec2 common = glm::min(size, old_size);
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, pictures_[i].framebuffer.name());
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, old[i].framebuffer.name());
    gl_->BlitFramebuffer(0, 0, common.x, common.y, 0, 0, common.x, common.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    make_mipmaps(i);
  }
}

void Target::clear() {
  if (size_.x == 0) return;
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    for (int face = 0; face < faces(); ++face) {
      bind(i, face);
      gl_->ClearBufferfv(GL_COLOR, 0, transparent_black.data());
    }
    make_mipmaps(i);
  }
}

void Target::copy(const Target& source, std::size_t from, std::size_t to) {
  const FramebufferObject reader(*gl_);  // framebuffers, unlike textures, are not shared
  for (int face = 0; face < faces(); ++face) {
    bind(to, face);
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, reader.name());
    gl_->FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(face),
                              source.texture(from), 0);
    gl_->BlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
}

void Target::bind(std::size_t picture, int face) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, pictures_[picture].framebuffer.name());
  if (faces() == 6)
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face_target(face), texture(picture), 0);
}

void Target::make_mipmaps(std::size_t picture) const {
  if (!mipmaps_) return;
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(kind_, texture(picture));
  gl_->GenerateMipmap(kind_);
}

Image Target::read(std::size_t picture) const {
  Image image(size_.x, size_.y * faces());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  for (int face = 0; face < faces(); ++face) {
    bind(picture, face);
    gl_->ReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, image.at(0, face * size_.y));
  }
  if (gl_->GetError() != GL_NO_ERROR)
    throw Error(ExitStatus::device, device_->name + ": the picture can't be read back");
  return image;
}

}  // namespace shadertwin::gl

#include "host/gl/channel_textures.h"

#include "host/player/inputs.h"
#include "host/player/keyboard.h"
#include "host/project/kinds.h"

namespace shadertwin::gl {

namespace {

// The target that the shader's sampler of an empty channel looks at.
GLenum target_of_empty(const Input& input) {
  const SamplerShape shape = info(input.missing).shape;
  if (shape == SamplerShape::cube) return GL_TEXTURE_CUBE_MAP;
  return shape == SamplerShape::volume ? GL_TEXTURE_3D : GL_TEXTURE_2D;
}

}  // namespace

ChannelTexture ChannelTextures::load(const Input& input) {
  switch (info(input.kind).source) {
    case InputSource::files: {
      const Picture& loaded = picture(input);
      return {{texture_target(loaded.texture), loaded.object.name()},
              channel_size(project_, input, &loaded.texture, {0, 0})};
    }
    case InputSource::keyboard:
      return {keyboard(), channel_size(project_, input, nullptr, {0, 0})};
    default:
      break;
  }
  MovingInput* moving = moving_.open(input);
  if (moving == nullptr && input.missing == InputKind::pass) return {missing_pass()};
  if (moving == nullptr) return {unbound(target_of_empty(input))};
  Moving& texture = moving_textures_[moving];
  const bool mipmaps = texture.mipmaps || uses_mipmaps(input.sampler.min);
  if (texture.object.name() == 0 || mipmaps != texture.mipmaps)
    texture = {upload(gl_, moving->texture(), mipmaps), mipmaps};
  return {{GL_TEXTURE_2D, texture.object.name()},
          channel_size(project_, input, &moving->texture(), {0, 0}),
          moving};
}

BoundTexture ChannelTextures::keyboard() {
  if (keyboard_.name() == 0) {
    keyboard_ = upload(gl_, keyboard_texture({}, rules_), false);
  }
  return {GL_TEXTURE_2D, keyboard_.name()};
}

void ChannelTextures::update(const Frame& frame) {
  upload_keyboard(frame);
  moving_.update(frame, [this](const MovingInput& input) {
    const auto found = moving_textures_.find(&input);
    if (found != moving_textures_.end()) upload_again(found->second, input.texture());
  });
}

ChannelTextures::Picture& ChannelTextures::picture(const Input& input) {
  const bool mipmaps = uses_mipmaps(input.sampler.min);
  std::string key = std::string(mipmaps ? "mipmaps" : "plain") + (input.sampler.vflip ? " flipped" : "") +
                    (input.red_only ? " red" : "");
  for (const auto& file : input.files) key += '\n' + file.string();
  auto found = pictures_.find(key);
  if (found == pictures_.end()) {
    Picture picture{load_texture(input), {}};
    picture.object = upload(gl_, picture.texture, mipmaps);
    picture.texture.data = {};
    found = pictures_.emplace(std::move(key), std::move(picture)).first;
  }
  return found->second;
}

BoundTexture ChannelTextures::unbound(GLenum target) {
  TextureObject& object = unbound_[target];
  if (object.name() == 0) object = make_unbound(gl_, target, rules_.empty_alpha);
  return {target, object.name()};
}

BoundTexture ChannelTextures::missing_pass() {
  if (missing_pass_.name() == 0) missing_pass_ = make_unbound(gl_, GL_TEXTURE_2D, 0);
  return {GL_TEXTURE_2D, missing_pass_.name()};
}

void ChannelTextures::upload_keyboard(const Frame& frame) {
  if (keyboard_.name() == 0) return;
  const Texture texture = keyboard_texture(frame.keyboard, rules_);
  gl_.BindTexture(GL_TEXTURE_2D, keyboard_.name());
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.width, texture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    texture.data.data());
}

void ChannelTextures::upload_again(const Moving& moving, const Texture& texture) {
  gl_.BindTexture(GL_TEXTURE_2D, moving.object.name());
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture.width, texture.height, GL_RGBA,
                    texture.format == Texture::Format::rgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                    texture.data.data());
  if (moving.mipmaps) gl_.GenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace shadertwin::gl

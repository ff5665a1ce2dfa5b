#include "reference/twin/surface.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace shadertwin::twin {

namespace {

// Rows of `values` numbers a pixel in a picture of another size, zero where there were none.
template <class T>
std::vector<T> resized(const std::vector<T>& old, glm::ivec2 old_size, glm::ivec2 size, int faces,
                       std::size_t values, bool keep) {
  std::vector<T> fresh(values * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                       static_cast<std::size_t>(faces));
  const glm::ivec2 common = keep ? glm::min(size, old_size) : glm::ivec2(0);
  for (int y = 0; y < common.y; ++y)
    std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(values) * old_size.x * y,
                values * static_cast<std::size_t>(common.x),
                fresh.begin() + static_cast<std::ptrdiff_t>(values) * size.x * y);
  return fresh;
}

}  // namespace

Surface::Surface(Texture texels, bool mipmaps) : texture_(std::move(texels)), mipmaps_(mipmaps) {
  finish_drawing();
}

Surface::Surface(int faces, bool mipmaps, Numbers numbers) : numbers_(numbers), mipmaps_(mipmaps) {
  texture_.format = Texture::Format::rgba32f;
  texture_.faces = faces;
  halves_ = faces > 1;
}

void Surface::upload(const Texture& texels) {
  texture_ = texels;
  finish_drawing();
}

void Surface::resize(glm::ivec2 size, bool keep) {
  texture_.data = resized(texture_.data, this->size(), size, faces(), texture_.texel_bytes(), keep);
  if (numbers_ == Numbers::doubles) doubles_ = resized(doubles_, this->size(), size, faces(), 4, keep);
  if (numbers_ == Numbers::shadows) shadows_ = resized(shadows_, this->size(), size, faces(), 4, keep);
  texture_.width = size.x;
  texture_.height = size.y;
  finish_drawing();
}

void Surface::clear() {
  if (texture_.width == 0) return;
  std::fill(texture_.data.begin(), texture_.data.end(), std::byte{0});
  std::fill(doubles_.begin(), doubles_.end(), 0.0);
  std::fill(shadows_.begin(), shadows_.end(), ShadowNumber{});
  finish_drawing();
}

void* Surface::pixels(std::size_t pixel) {
  if (numbers_ == Numbers::doubles) return doubles_.data() + 4 * pixel;
  if (numbers_ == Numbers::shadows) return shadows_.data() + 4 * pixel;
  return texture_.data.data() + texture_.texel_bytes() * pixel;
}

void Surface::finish_drawing() {
  auto* floats = reinterpret_cast<float*>(texture_.data.data());
  std::transform(doubles_.begin(), doubles_.end(), floats, [](double v) { return static_cast<float>(v); });
  std::transform(shadows_.begin(), shadows_.end(), floats, [](const ShadowNumber& v) { return v.value; });
  image_ = std::make_unique<glsl::TextureImage>(texture_, mipmaps_, halves_);
  if (!shadows_.empty()) finish_companions();
}

void Surface::finish_companions() {
  const auto make = [this](Companion& companion, auto part) {
    companion.texture = texture_;
    auto* floats = reinterpret_cast<float*>(companion.texture.data.data());
    std::transform(shadows_.begin(), shadows_.end(), floats, part);
    companion.image = std::make_unique<glsl::TextureImage>(companion.texture, mipmaps_);
  };
  const auto high = [](const ShadowNumber& v) { return static_cast<float>(v.exact); };
  make(companions_[0], high);
  make(companions_[1], [&](const ShadowNumber& v) {
    const double rest = v.exact - static_cast<double>(high(v));
    return std::isfinite(rest) ? static_cast<float>(rest) : 0.0F;
  });
  make(companions_[2], [](const ShadowNumber& v) { return static_cast<float>(v.origin); });
}

glsl::ShadowViews Surface::shadow_views() const {
  if (shadows_.empty()) return {};
  return {&companions_[0].image->view(), &companions_[1].image->view(), &companions_[2].image->view()};
}

Image Surface::read() const {
  Image image(texture_.width, texture_.height * texture_.faces);
  if (!texture_.data.empty()) std::memcpy(image.rgba.data(), texture_.data.data(), texture_.data.size());
  return image;
}

}  // namespace shadertwin::twin

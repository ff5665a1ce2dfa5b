#include "reference/glsl/texture_image.h"

#include <algorithm>

#include "host/base/assert.h"
#include "reference/glsl/denormals.h"
#include "reference/glsl/mipmaps.h"
#include "reference/glsl/sample.h"

namespace shadertwin::glsl {

namespace {

using Mipmaps = SamplerState::Mipmaps;

SamplerState state_of(const shadertwin::Sampler& sampler) {
  SamplerState state;
  state.mag_linear = sampler.mag == MagFilter::linear;
  switch (sampler.min) {
    case MinFilter::nearest:
      break;
    case MinFilter::linear:
      state.min_linear = true;
      break;
    case MinFilter::nearest_mipmap_nearest:
      state.mipmaps = Mipmaps::nearest;
      break;
    case MinFilter::nearest_mipmap_linear:
      state.mipmaps = Mipmaps::linear;
      break;
    case MinFilter::linear_mipmap_nearest:
      state.min_linear = true;
      state.mipmaps = Mipmaps::nearest;
      break;
    case MinFilter::linear_mipmap_linear:
      state.min_linear = true;
      state.mipmaps = Mipmaps::linear;
      break;
  }
  switch (sampler.wrap) {
    case shadertwin::Wrap::repeat:
      state.wrap = SamplerState::Wrap::repeat;
      break;
    case shadertwin::Wrap::clamp:
      state.wrap = SamplerState::Wrap::clamp;
      break;
    case shadertwin::Wrap::mirror:
      state.wrap = SamplerState::Wrap::mirror;
      break;
  }
  return state;
}

BoundTexture bound(const TextureImage* image, const shadertwin::Sampler& sampler, const Sampling& sampling) {
  if (image == nullptr) return {};
  return {&image->view(), &sampling, state_of(sampler)};
}

}  // namespace

TextureImage::TextureImage(const Texture& texture, bool mipmaps, bool halves) {
  SHADERTWIN_ASSERT_EQ(texture.data.size(), texture.texel_bytes() * texture.width * texture.height *
                                                texture.depth * texture.faces);
  view_.is_float = texture.format == Texture::Format::rgba32f;
  view_.levels = 1;
  view_.level[0] = {texture.data.data(), texture.width, texture.height, texture.depth};
  if (mipmaps) add_mipmaps(texture.faces, halves);
}

void TextureImage::add_mipmaps(int faces, bool halves) {
  const Texel texel = !view_.is_float ? Texel::bytes : halves ? Texel::halves : Texel::floats;
  const FlushDenormals flush;
  while (view_.levels < TextureView::max_levels) {
    const TextureLevel& from = view_.level[view_.levels - 1];
    if (from.width == 1 && from.height == 1 && from.depth == 1) return;
    TextureLevel to{nullptr, std::max(1, from.width / 2), std::max(1, from.height / 2),
                    std::max(1, from.depth / 2)};
    const int layers = to.depth * faces;
    const std::size_t texel_bytes = view_.is_float ? 16 : 4;
    mipmaps_.emplace_back(texel_bytes * to.width * to.height * layers);
    shrink(texel, from, to, mipmaps_.back().data(), layers);
    to.texels = mipmaps_.back().data();
    view_.level[view_.levels++] = to;
  }
}

sampler2D bind2d(const TextureImage* image, const shadertwin::Sampler& sampler) {
  return {bound(image, sampler, sampling_2d())};
}
sampler3D bind3d(const TextureImage* image, const shadertwin::Sampler& sampler) {
  return {bound(image, sampler, sampling_3d())};
}
samplerCube bindcube(const TextureImage* image, const shadertwin::Sampler& sampler) {
  return {bound(image, sampler, sampling_cube())};
}

}  // namespace shadertwin::glsl

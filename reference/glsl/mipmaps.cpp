#include "reference/glsl/mipmaps.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "reference/glsl/filtering.h"
#include "reference/glsl/sample.h"

namespace shadertwin::glsl {

namespace {

struct Corner {
  float x, y;  // pixels
  float s, t;
};

// A value that is linear over a triangle, with the coefficients of llvmpipe's triangle setup
// (lp_state_setup.c).
struct Plane {
  float origin, dx, dy;

  float at(int x, int y) const {
    return detail::multiply_add(dy, static_cast<float>(y),
                                detail::multiply_add(dx, static_cast<float>(x), origin));
  }
};

Plane plane(const Corner (&v)[3], float Corner::*value) {
  float dx01 = v[0].x - v[1].x;
  float dy01 = v[0].y - v[1].y;
  float dx20 = v[2].x - v[0].x;
  float dy20 = v[2].y - v[0].y;
  const float per_area = 1.0F / (dx01 * dy20 - dy01 * dx20);
  dx01 *= per_area;
  dy01 *= per_area;
  dx20 *= per_area;
  dy20 *= per_area;
  const float d01 = v[0].*value - v[1].*value;
  const float d20 = v[2].*value - v[0].*value;
  const float dx = d01 * dy20 - d20 * dy01;
  const float dy = d20 * dx01 - d01 * dx20;
  return {v[0].*value - (dx * (v[0].x - 0.5F) + dy * (v[0].y - 0.5F)), dx, dy};
}

// The texture coordinates, from 0 to 1, of the quad of two triangles that a level is drawn as.
class QuadCoordinates {
 public:
  QuadCoordinates(int width, int height) : width_(width), height_(height) {
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    const Corner lower[3] = {{w, 0, 1, 0}, {w, h, 1, 1}, {0, 0, 0, 0}};
    const Corner upper[3] = {{w, h, 1, 1}, {0, h, 0, 1}, {0, 0, 0, 0}};
    s_[0] = plane(lower, &Corner::s);
    t_[0] = plane(lower, &Corner::t);
    s_[1] = plane(upper, &Corner::s);
    t_[1] = plane(upper, &Corner::t);
  }
  float s(int x, int y) const { return s_[triangle(x, y)].at(x, y); }
  float t(int x, int y) const { return t_[triangle(x, y)].at(x, y); }

 private:
  // The diagonal's own pixels belong to the lower triangle.
  int triangle(int x, int y) const { return (2 * y + 1) * width_ > (2 * x + 1) * height_ ? 1 : 0; }

  int width_;
  int height_;
  Plane s_[2];
  Plane t_[2];
};

// The half next to a float on the side of zero, as llvmpipe writes what it draws.
float cut_to_half(float x) {
  const float size = std::fabs(x);
  if (size < 0x1p-14F) return std::trunc(x * 0x1p24F) * 0x1p-24F;
  if (size > 65504.0F && std::isfinite(x)) return std::copysign(65504.0F, x);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0xffffe000U);
}

}  // namespace

// Each texel is a linear sample of the level above.
void shrink(Texel texel, const TextureLevel& from, const TextureLevel& to, std::byte* texels, int layers) {
  const bool is_float = texel != Texel::bytes;
  TextureView source;
  source.is_float = is_float;
  source.levels = 1;
  SamplerState state;
  state.min_linear = state.mag_linear = true;
  state.wrap = SamplerState::Wrap::clamp;
  const bool volume = from.depth > 1;
  const Sampling& sampling = volume ? sampling_3d() : sampling_2d();
  const QuadCoordinates quad(to.width, to.height);
  const int offset[3] = {0, 0, 0};
  const std::size_t texel_bytes = is_float ? 16 : 4;
  const std::size_t layer_bytes = texel_bytes * static_cast<std::size_t>(from.width) * from.height;
  for (int z = 0; z < layers; ++z) {
    source.level[0] = from;
    if (!volume) source.level[0].texels = static_cast<const std::byte*>(from.texels) + layer_bytes * z;
    for (int y = 0; y < to.height; ++y) {
      for (int x = 0; x < to.width; ++x, texels += texel_bytes) {
        const float p[3] = {quad.s(x, y), quad.t(x, y),
                            (static_cast<float>(z) + 0.5F) / static_cast<float>(to.depth)};
        float rgba[4];
        sampling.sample(source, state, p, offset, LodRequest{}, rgba);
        if (texel == Texel::halves)
          for (float& value : rgba) value = cut_to_half(value);
        if (is_float) {
          std::memcpy(texels, rgba, sizeof rgba);
        } else {
          for (int c = 0; c < 4; ++c)
            texels[c] = static_cast<std::byte>(filtering::to_nearest(rgba[c] * 255.0F));
        }
      }
    }
  }
}

}  // namespace shadertwin::glsl

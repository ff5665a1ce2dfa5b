// The arithmetic of texture filtering as llvmpipe does it (gallivm's lp_bld_sample*.c): which texels a
// coordinate touches along one axis, and how their values are blended.
#pragma once

#include <algorithm>
#include <array>

#include "reference/glsl/sampler.h"

#ifdef SHADERTWIN_DOUBLE
#error "filtering is float32 in every build"
#endif

namespace shadertwin::glsl::filtering {

using Color = std::array<float, 4>;
using Wrap = SamplerState::Wrap;

// --- Conversions ------------------------------------------------------------

inline int toward_zero(float x) {
#if defined(__SSE2__)
  return _mm_cvttss_si32(detail::lane(x));
#else
  return detail::to_int(x);
#endif
}
inline int to_nearest(float x) {
#if defined(__SSE2__)
  return _mm_cvtss_si32(detail::lane(x));
#else
  return detail::to_int(std::rint(x));
#endif
}
inline int down(float x) {
  return toward_zero(std::floor(x));
}

// Below 1 also where rounding would give 1, and for a NaN.
inline float safe_fraction(float x) {
  return detail::first_if_less(x - std::floor(x), 0x1.fffffep-1F);
}

// The triangle wave of period 2 that mirrored repetition is. 0 for a NaN.
inline float mirrored(float x) {
  const float half = x * 0.5F;
  const float fraction = half - std::rint(half);
  return detail::first_if_greater(std::fabs(fraction + fraction), 0.0F);
}

// --- One axis of nearest filtering ------------------------------------------

// `length`: texels of the level; `power_of_two`: whether the base level's is one. `whole_offset`: the path
// for RGBA8 adds the offset after rounding.
inline int nearest_texel(float x, int length, int offset, Wrap wrap, bool power_of_two, bool whole_offset) {
  const auto size = static_cast<float>(length);
  switch (wrap) {
    case Wrap::repeat:
      if (power_of_two) return (down(x * size) + offset) & (length - 1);
      if (offset != 0) x = x + static_cast<float>(offset) / size;
      return toward_zero(safe_fraction(x) * size);
    case Wrap::clamp:
      if (whole_offset) return std::clamp(down(x * size) + offset, 0, length - 1);
      x = x * size;
      if (offset != 0) x = x + static_cast<float>(offset);
      return std::clamp(toward_zero(x), 0, length - 1);
    case Wrap::mirror:
      if (offset != 0) x = x + static_cast<float>(offset) / size;
      return std::min(toward_zero(mirrored(x) * size), length - 1);
  }
  return 0;
}

// --- One axis of linear filtering -------------------------------------------

// Two texels and the weight of the second.
struct Pair {
  int first;
  int second;
  float weight;
};

inline Pair linear_texels(float x, int length, int offset, Wrap wrap, bool power_of_two) {
  const auto size = static_cast<float>(length);
  const auto split = [](float texel) {
    const float whole = std::floor(texel);
    return Pair{toward_zero(whole), toward_zero(whole) + 1, texel - whole};
  };
  switch (wrap) {
    case Wrap::repeat: {
      if (power_of_two) {
        x = x * size - 0.5F;
        if (offset != 0) x = x + static_cast<float>(offset);
        const Pair pair = split(x);
        return {pair.first & (length - 1), pair.second & (length - 1), pair.weight};
      }
      if (offset != 0) x = x + static_cast<float>(offset) / size;
      x = (x - std::floor(x)) * size - 0.5F;
      Pair pair = split(x);
      if (!(x >= 0.0F)) pair.first = length - 1;
      pair.second = pair.first != length - 1 ? pair.first + 1 : 0;
      return pair;
    }
    case Wrap::clamp: {
      x = x * size;
      if (offset != 0) x = x + static_cast<float>(offset);
      x = detail::first_if_greater(detail::first_if_less(x, size) - 0.5F, 0.0F);
      const Pair pair = split(x);
      return {pair.first, std::min(pair.second, length - 1), pair.weight};
    }
    case Wrap::mirror: {
      if (offset != 0) x = x + static_cast<float>(offset) / size;
      const Pair pair = split(mirrored(x) * size - 0.5F);
      return {std::max(pair.first, 0), std::min(pair.second, length - 1), pair.weight};
    }
  }
  return {0, 0, 0.0F};
}

// As above with 8 bits of weight, for RGBA8.
struct FixedPair {
  int first;
  int second;
  int weight;
};

inline FixedPair fixed_texels(float x, int length, int offset, Wrap wrap, bool power_of_two) {
  if (wrap == Wrap::repeat && !power_of_two) {
    const auto size = static_cast<float>(length);
    if (offset != 0) x = x + static_cast<float>(offset) / size;
    const int position = to_nearest((x - std::floor(x)) * size * 256.0F) - 128;
    int first = position >> 8;
    if (first < 0) first = length - 1;
    first = std::min(first, length - 1);
    return {first, first != length - 1 ? first + 1 : 0, position & 255};
  }
  const int position = to_nearest(x * static_cast<float>(length << 8)) - 128;
  const int texel = (position >> 8) + offset;
  if (wrap == Wrap::repeat) {
    const int first = texel & (length - 1);
    return {first, first != length - 1 ? first + 1 : 0, position & 255};
  }
  const bool from = texel >= 0;
  const bool to = texel < length - 1;
  const int first = !to ? length - 1 : from ? texel : 0;
  return {first, from && to ? first + 1 : first, position & 255};
}

// --- Blending ---------------------------------------------------------------

inline float blend(float weight, float a, float b) {
  return detail::multiply_add(weight, b - a, a);
}
inline Color blend(float weight, const Color& a, const Color& b) {
  return {blend(weight, a[0], b[0]), blend(weight, a[1], b[1]), blend(weight, a[2], b[2]),
          blend(weight, a[3], b[3])};
}

using Bytes = std::array<std::uint8_t, 4>;

// pmulhrsw: the product is rounded at its 8th bit.
inline std::uint8_t blend(int weight, std::uint8_t a, std::uint8_t b) {
  return static_cast<std::uint8_t>(a + ((weight * (b - a) + 128) >> 8));
}
inline Bytes blend(int weight, const Bytes& a, const Bytes& b) {
  return {blend(weight, a[0], b[0]), blend(weight, a[1], b[1]), blend(weight, a[2], b[2]),
          blend(weight, a[3], b[3])};
}

inline Color to_color(const Bytes& bytes) {
  constexpr float scale = 1.0F / 255.0F;
  return {static_cast<float>(bytes[0]) * scale, static_cast<float>(bytes[1]) * scale,
          static_cast<float>(bytes[2]) * scale, static_cast<float>(bytes[3]) * scale};
}

// --- Texels -----------------------------------------------------------------

// `layer`: a slice or a face.
inline std::size_t texel_index(const TextureLevel& level, int x, int y, int layer) {
  return (static_cast<std::size_t>(layer) * level.height + static_cast<std::size_t>(y)) * level.width +
         static_cast<std::size_t>(x);
}
inline Bytes bytes_at(const TextureLevel& level, int x, int y, int layer) {
  const auto* rgba = static_cast<const std::uint8_t*>(level.texels) + 4 * texel_index(level, x, y, layer);
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}
inline Color color_at(const TextureView& view, const TextureLevel& level, int x, int y, int layer) {
  if (!view.is_float) return to_color(bytes_at(level, x, y, layer));
  const auto* rgba = static_cast<const float*>(level.texels) + 4 * texel_index(level, x, y, layer);
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

// --- Cubes ------------------------------------------------------------------

// Where a direction meets the cube.
struct CubePoint {
  int face;  // +X -X +Y -Y +Z -Z
  float s;
  float t;
};
CubePoint cube_point(const float* direction);

// LodRequest::footprint on the face that `direction` meets.
float cube_footprint(const TextureView& view, const float* direction, const float* dx, const float* dy);

// Whether linear filtering at `point` reaches beyond a corner of its face, where the cube has three texels.
bool meets_corner(const TextureLevel& level, const CubePoint& point);

// Linear filtering across the edges of faces. `weighted`: adds up weighted texels also where no corner is
// met, as llvmpipe does as soon as one of the pixels that run together meets one.
Color cube_linear(const TextureView& view, const TextureLevel& level, const CubePoint& point, bool weighted);

}  // namespace shadertwin::glsl::filtering

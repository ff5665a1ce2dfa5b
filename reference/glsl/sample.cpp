#include "reference/glsl/sample.h"

#include <bit>
#include <cmath>

#include "reference/glsl/filtering.h"

namespace shadertwin::glsl {

namespace {

using filtering::Bytes;
using filtering::Color;
using Mipmaps = SamplerState::Mipmaps;

enum class Shape { flat, volume, cube };

// --- Level of detail --------------------------------------------------------

// Linear between powers of two.
float fast_log2(float x) {
  const uint pattern = std::bit_cast<uint>(x);
  const int exponent = static_cast<int>((pattern >> 23) & 255U) - 128;
  return static_cast<float>(exponent) + std::bit_cast<float>((pattern & 0x7fffffU) | 0x3f800000U);
}

// log2 of the root of x, rounded.
int rounded_log2_of_root(float x) {
  return (static_cast<int>((std::bit_cast<uint>(x) >> 23) & 255U) - 126) >> 1;
}

struct Levels {
  bool minified = false;
  int first = 0;
  int second = 0;
  float weight = 0.0F;  // of the second
};

Levels choose_levels(const TextureView& view, const SamplerState& state, const LodRequest& request) {
  Levels levels;
  if (state.mipmaps == Mipmaps::none && state.min_linear == state.mag_linear) return levels;
  const int last = view.levels - 1;
  if (request.kind == LodRequest::Kind::footprint && state.mipmaps != Mipmaps::linear) {
    levels.minified = request.footprint > 1.0F;
    if (state.mipmaps == Mipmaps::nearest) {
      levels.first = std::clamp(rounded_log2_of_root(request.footprint), 0, last);
    }
    return levels;
  }
  float lod = request.level;
  if (request.kind == LodRequest::Kind::footprint) lod = fast_log2(request.footprint) * 0.5F;
  if (request.kind == LodRequest::Kind::biased_footprint) lod = fast_log2(request.footprint) * 0.5F + lod;
  levels.minified = !(lod <= 0.0F);
  if (state.mipmaps == Mipmaps::nearest) {
    levels.first = std::clamp(filtering::to_nearest(lod), 0, last);
  } else if (state.mipmaps == Mipmaps::linear) {
    const float whole = std::floor(lod);
    levels.first = filtering::toward_zero(whole);
    levels.weight = lod - whole;
    levels.second = levels.first + 1;
    if (levels.first < 0 || levels.first >= last) {
      levels.first = levels.second = levels.first < 0 ? 0 : last;
      levels.weight = 0.0F;
    }
  }
  return levels;
}

// --- One level --------------------------------------------------------------

struct LevelSampler {
  const TextureView& view;
  SamplerState::Wrap wrap;
  const float* p;     // coordinates; of a cube those on `face`
  const int* offset;  // texels
  int face;
  unsigned corners;  // LodRequest::corners

  bool power_of_two(int axis) const {
    const TextureLevel& base = view.level[0];
    return std::has_single_bit(static_cast<uint>(axis == 0   ? base.width
                                                 : axis == 1 ? base.height
                                                             : base.depth));
  }
};

template <Shape shape>
std::array<int, 3> nearest(const LevelSampler& s, const TextureLevel& level, bool whole_offset) {
  const int x =
      filtering::nearest_texel(s.p[0], level.width, s.offset[0], s.wrap, s.power_of_two(0), whole_offset);
  const int y =
      filtering::nearest_texel(s.p[1], level.height, s.offset[1], s.wrap, s.power_of_two(1), whole_offset);
  const int z = shape == Shape::volume ? filtering::nearest_texel(s.p[2], level.depth, s.offset[2], s.wrap,
                                                                  s.power_of_two(2), whole_offset)
                                       : s.face;
  return {x, y, z};
}

template <Shape shape>
Color color_of_level(const LevelSampler& s, int which, bool second, bool linear) {
  const TextureLevel& level = s.view.level[which];
  if (!linear) {
    const auto [x, y, z] = nearest<shape>(s, level, false);
    return filtering::color_at(s.view, level, x, y, z);
  }
  if constexpr (shape == Shape::cube) {
    const bool weighted = ((s.corners >> (second ? 1 : 0)) & 1U) != 0;
    return filtering::cube_linear(s.view, level, {s.face, s.p[0], s.p[1]}, weighted);
  } else {
    const auto x = filtering::linear_texels(s.p[0], level.width, s.offset[0], s.wrap, s.power_of_two(0));
    const auto y = filtering::linear_texels(s.p[1], level.height, s.offset[1], s.wrap, s.power_of_two(1));
    const auto slice = [&](int z) {
      const auto row = [&](int ty) {
        return filtering::blend(x.weight, filtering::color_at(s.view, level, x.first, ty, z),
                                filtering::color_at(s.view, level, x.second, ty, z));
      };
      return filtering::blend(y.weight, row(y.first), row(y.second));
    };
    if constexpr (shape == Shape::flat) return slice(0);
    const auto z = filtering::linear_texels(s.p[2], level.depth, s.offset[2], s.wrap, s.power_of_two(2));
    return filtering::blend(z.weight, slice(z.first), slice(z.second));
  }
}

template <Shape shape>
Bytes bytes_of_level(const LevelSampler& s, const TextureLevel& level, bool linear) {
  if (!linear || shape == Shape::cube) {
    const auto [x, y, z] = nearest<shape>(s, level, true);
    return filtering::bytes_at(level, x, y, z);
  }
  const auto x = filtering::fixed_texels(s.p[0], level.width, s.offset[0], s.wrap, s.power_of_two(0));
  const auto y = filtering::fixed_texels(s.p[1], level.height, s.offset[1], s.wrap, s.power_of_two(1));
  const auto slice = [&](int z) {
    const auto row = [&](int ty) {
      return filtering::blend(x.weight, filtering::bytes_at(level, x.first, ty, z),
                              filtering::bytes_at(level, x.second, ty, z));
    };
    return filtering::blend(y.weight, row(y.first), row(y.second));
  };
  if constexpr (shape != Shape::volume) return slice(0);
  const auto z = filtering::fixed_texels(s.p[2], level.depth, s.offset[2], s.wrap, s.power_of_two(2));
  return filtering::blend(z.weight, slice(z.first), slice(z.second));
}

// --- The whole --------------------------------------------------------------

bool uses_linear(const SamplerState& state, const Levels& levels) {
  const bool minifies = state.min_linear == state.mag_linear || levels.minified;
  return minifies ? state.min_linear : state.mag_linear;
}

template <Shape shape>
void sample(const TextureView& view, const SamplerState& state, const float* coordinates, const int* offset,
            const LodRequest& request, float* rgba) {
  const Levels levels = choose_levels(view, state, request);
  LevelSampler sampler{view, state.wrap, coordinates, offset, 0, request.corners};
  float on_face[2];
  if constexpr (shape == Shape::cube) {
    const filtering::CubePoint point = filtering::cube_point(coordinates);
    on_face[0] = point.s;
    on_face[1] = point.t;
    sampler.p = on_face;
    sampler.face = point.face;
    sampler.wrap = SamplerState::Wrap::clamp;
  }
  const bool same = state.min_linear == state.mag_linear;
  const bool linear = uses_linear(state, levels);
  const bool second = (same || levels.minified) && levels.weight > 0.0F;

  // llvmpipe filters RGBA8 with 8 bits of weight where the wrap is simple, no cube's edge has to be crossed,
  // and a choice between two filters is made for a whole quad.
  const bool fixed = !view.is_float && sampler.wrap != SamplerState::Wrap::mirror &&
                     !(shape == Shape::cube && (state.min_linear || state.mag_linear)) &&
                     (same || (request.kind == LodRequest::Kind::footprint && !request.own));
  Color color;
  if (fixed) {
    Bytes bytes = bytes_of_level<shape>(sampler, view.level[levels.first], linear);
    const int weight = filtering::toward_zero(levels.weight * 256.0F);
    if (second && weight > 0) {
      bytes =
          filtering::blend(weight, bytes, bytes_of_level<shape>(sampler, view.level[levels.second], linear));
    }
    color = filtering::to_color(bytes);
  } else {
    color = color_of_level<shape>(sampler, levels.first, false, linear);
    if (second) {
      color =
          filtering::blend(levels.weight, color, color_of_level<shape>(sampler, levels.second, true, linear));
    }
  }
  std::copy(color.begin(), color.end(), rgba);
}

template <Shape shape>
float footprint(const TextureView& view, const float* coordinates, const float* dx, const float* dy,
                bool of_quad) {
  if constexpr (shape == Shape::cube) return filtering::cube_footprint(view, coordinates, dx, dy);
  const TextureLevel& base = view.level[0];
  const float size[3] = {static_cast<float>(base.width), static_cast<float>(base.height),
                         static_cast<float>(base.depth)};
  const auto squared_step = [&](const float* d) {
    const float s = d[0] * size[0];
    const float t = d[1] * size[1];
    float sum = s * s + t * t;
    if constexpr (shape == Shape::volume) {
      const float r = d[2] * size[2];
      sum = sum + r * r;
    }
    return sum;
  };
  const float longer = detail::first_if_greater(squared_step(dx), squared_step(dy));
  return of_quad || longer < detail::infinity ? longer : 0.0F;
}

unsigned corners(const TextureView& view, const SamplerState& state, const float* coordinates,
                 const LodRequest& request) {
  const Levels levels = choose_levels(view, state, request);
  if (!uses_linear(state, levels)) return 0;
  const filtering::CubePoint point = filtering::cube_point(coordinates);
  return (filtering::meets_corner(view.level[levels.first], point) ? 1U : 0U) |
         (filtering::meets_corner(view.level[levels.second], point) ? 2U : 0U);
}

constexpr Sampling flat_sampling{&sample<Shape::flat>, &footprint<Shape::flat>, nullptr};
constexpr Sampling volume_sampling{&sample<Shape::volume>, &footprint<Shape::volume>, nullptr};
constexpr Sampling cube_sampling{&sample<Shape::cube>, &footprint<Shape::cube>, &corners};

}  // namespace

const Sampling& sampling_2d() {
  return flat_sampling;
}
const Sampling& sampling_3d() {
  return volume_sampling;
}
const Sampling& sampling_cube() {
  return cube_sampling;
}

}  // namespace shadertwin::glsl

// Samplers as values: what a shader's sampler2D, sampler3D and samplerCube are, and every function that reads
// them.
//
// Texels and filtering are float32 also where Float is double. The filtering itself is compiled once
// (sample.cpp) and reached through pointers, so that a shader does not compile it again and needs no library.
#pragma once

#include "reference/glsl/builtins.h"

namespace shadertwin::glsl {

// --- What is bound ----------------------------------------------------------

// One mipmap level. Faces of a cube or slices of a volume follow one another.
struct TextureLevel {
  const void* texels = nullptr;
  int width = 0;
  int height = 0;
  int depth = 1;
};

struct TextureView {
  static constexpr int max_levels = 15;  // 16384 texels
  bool is_float = false;                 // RGBA32F, else RGBA8
  int levels = 0;
  TextureLevel level[max_levels];
};

struct SamplerState {
  enum class Mipmaps { none, nearest, linear };
  enum class Wrap { repeat, clamp, mirror };
  bool min_linear = false;
  bool mag_linear = false;
  Mipmaps mipmaps = Mipmaps::none;
  Wrap wrap = Wrap::repeat;
};

// How a call says which level it wants.
struct LodRequest {
  enum class Kind { footprint, biased_footprint, level };
  Kind kind = Kind::footprint;
  float footprint = 0.0F;  // square of the longer of a pixel's two steps, in texels
  float level = 0.0F;      // the level, or the bias
  bool own = false;        // the footprint is one pixel's, not its quad's
  unsigned corners = 0;    // Sampling::corners of all pixels that run together
};

struct Sampling {
  void (*sample)(const TextureView& view, const SamplerState& state, const float* coordinates,
                 const int* offset, const LodRequest& lod, float* rgba);
  // LodRequest::footprint for derivatives of the coordinates along x and y.
  float (*footprint)(const TextureView& view, const float* coordinates, const float* dx, const float* dy,
                     bool of_quad);
  // Cubes only: whether linear filtering meets a corner of the cube, bit 0 for the first of the two levels
  // that may be blended, bit 1 for the second.
  unsigned (*corners)(const TextureView& view, const SamplerState& state, const float* coordinates,
                      const LodRequest& lod);
};

// What shadows (shadow.h) know of a texture that they have drawn, as three more pictures: the exact texels
// are the sums of the first two, the third holds their origins as numbers.
struct ShadowViews {
  const TextureView* high = nullptr;  // null: the texels are exact
  const TextureView* low = nullptr;
  const TextureView* origin = nullptr;
};

struct BoundTexture {
  const TextureView* view = nullptr;  // null: nothing is bound, and black is read
  const Sampling* sampling = nullptr;
  SamplerState state;
  ShadowViews shadows{};
};

struct sampler2D {
  BoundTexture bound;
};
struct sampler3D {
  BoundTexture bound;
};
struct samplerCube {
  BoundTexture bound;
};

// --- Derivatives ------------------------------------------------------------

// A value in the four pixels (0, 0), (1, 0), (0, 1), (1, 1) of a square whose first pixel has even
// coordinates.
template <class T>
struct Quad {
  T v[4];
};

// As llvmpipe has them: rows and columns of the quad differ.
template <class T>
SHADERTWIN_INLINE T dFdx(const Quad<T>& quad, int lane) {
  return quad.v[lane | 1] - quad.v[lane & 2];
}
template <class T>
SHADERTWIN_INLINE T dFdy(const Quad<T>& quad, int lane) {
  return quad.v[lane | 2] - quad.v[lane & 1];
}
template <class T>
SHADERTWIN_INLINE T fwidth(const Quad<T>& quad, int lane) {
  return abs(dFdx(quad, lane)) + abs(dFdy(quad, lane));
}

// --- Level of detail --------------------------------------------------------

// The level that a quad's coordinates ask for. Lod{} is the base level, magnified.
struct Lod {
  float footprint = 0.0F;
};

// Whether the level can make a difference: without, Lod{} serves and a quad need not run together.
inline bool needs_lod(const BoundTexture& bound) {
  if (bound.view == nullptr) return false;
  return bound.state.min_linear != bound.state.mag_linear ||
         (bound.state.mipmaps != SamplerState::Mipmaps::none && bound.view->levels > 1);
}
inline bool needs_lod(const sampler2D& s) {
  return needs_lod(s.bound);
}
inline bool needs_lod(const sampler3D& s) {
  return needs_lod(s.bound);
}
inline bool needs_lod(const samplerCube& s) {
  return needs_lod(s.bound);
}

}  // namespace shadertwin::glsl

namespace shadertwin::glsl::inline SHADERTWIN_PRECISION {

namespace detail {

struct Coordinates {
  float v[3];
};
SHADERTWIN_INLINE Coordinates coordinates(vec2 p) {
  return {{static_cast<float>(p.x), static_cast<float>(p.y), 0.0F}};
}
SHADERTWIN_INLINE Coordinates coordinates(vec3 p) {
  return {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}};
}

template <class Vector>
Lod lod_from_steps(const BoundTexture& bound, const Quad<Vector>& p, int lane, bool of_quad) {
  if (bound.view == nullptr) return {};
  const Coordinates at[4] = {coordinates(p.v[0]), coordinates(p.v[1]), coordinates(p.v[2]),
                             coordinates(p.v[3])};
  float dx[3];
  float dy[3];
  for (int i = 0; i < 3; ++i) {
    dx[i] = at[lane | 1].v[i] - at[lane & 2].v[i];
    dy[i] = at[lane | 2].v[i] - at[lane & 1].v[i];
  }
  return {bound.sampling->footprint(*bound.view, at[lane].v, dx, dy, of_quad)};
}

#ifdef SHADERTWIN_SHADOW
SHADERTWIN_INLINE Shadow worse(const Shadow& a, const Shadow& b) {
  return error_of(b) > error_of(a) ? b : a;
}
SHADERTWIN_INLINE Shadow worst_of(vec2 p) {
  return worse(p.x, p.y);
}
SHADERTWIN_INLINE Shadow worst_of(vec3 p) {
  return worse(worse(p.x, p.y), p.z);
}

// The double halves of what was read as `rgba`: what the exact coordinates read of the exact texels. Filters
// are linear, so that of sums the sum of what is read.
template <class Vector>
vec4 with_shadows(const BoundTexture& bound, Vector p, const LodRequest& lod, ivec3 offset,
                  const float* rgba) {
  vec4 result(rgba[0], rgba[1], rgba[2], rgba[3]);
  Vector exact;
  bool moved = false;
  for (int i = 0; i < Vector::length(); ++i) {
    exact[i] = static_cast<float>(p[i].exact);
    moved = moved || exact[i].value != p[i].value;
  }
  if (!moved && bound.shadows.high == nullptr) return result;
  const auto sample = [&](const TextureView& view, const SamplerState& state, float* texel) {
    bound.sampling->sample(view, state, coordinates(exact).v, &offset.x, lod, texel);
  };
  float texel[4];
  float low[4] = {};
  sample(bound.shadows.high != nullptr ? *bound.shadows.high : *bound.view, bound.state, texel);
  if (bound.shadows.low != nullptr) sample(*bound.shadows.low, bound.state, low);
  for (int i = 0; i < 4; ++i) {
    result[i].exact = texel[i];
    if (low[i] != 0.0F) result[i].exact += low[i];
  }
  if (is_plain(result.x) && is_plain(result.y) && is_plain(result.z) && is_plain(result.w)) return result;
  SamplerState nearest;
  nearest.wrap = bound.state.wrap;
  float origin[4] = {};
  if (bound.shadows.origin != nullptr) sample(*bound.shadows.origin, nearest, origin);
  const std::uint32_t of_place = worst_of(p).origin;
  for (int i = 0; i < 4; ++i) result[i].origin = origin[i] != 0.0F ? static_cast<uint>(origin[i]) : of_place;
  return result;
}
#endif

template <class Vector>
vec4 sampled(const BoundTexture& bound, Vector p, const LodRequest& lod, ivec3 offset = ivec3(0)) {
  if (bound.view == nullptr) return vec4(0, 0, 0, 1);
  float rgba[4];
  bound.sampling->sample(*bound.view, bound.state, coordinates(p).v, &offset.x, lod, rgba);
#ifdef SHADERTWIN_SHADOW
  return with_shadows(bound, p, lod, offset, rgba);
#else
  return vec4(rgba[0], rgba[1], rgba[2], rgba[3]);
#endif
}

SHADERTWIN_INLINE LodRequest request(Lod lod) {
  return {LodRequest::Kind::footprint, lod.footprint, 0.0F, false};
}
SHADERTWIN_INLINE LodRequest request(Lod lod, Float bias) {
  return {LodRequest::Kind::biased_footprint, lod.footprint, static_cast<float>(bias), false};
}
SHADERTWIN_INLINE LodRequest request(Float level) {
  return {LodRequest::Kind::level, 0.0F, static_cast<float>(level), true};
}
template <class Vector>
LodRequest request(const BoundTexture& bound, Vector p, Vector dx, Vector dy) {
  if (bound.view == nullptr) return {};
  return {
      LodRequest::Kind::footprint,
      bound.sampling->footprint(*bound.view, coordinates(p).v, coordinates(dx).v, coordinates(dy).v, false),
      0.0F, true};
}

inline ivec3 size_of(const BoundTexture& bound, int lod) {
  if (bound.view == nullptr) return ivec3(1);
  if (lod < 0 || lod >= bound.view->levels) return ivec3(0);
  const TextureLevel& level = bound.view->level[lod];
  return ivec3(level.width, level.height, level.depth);
}

// Nothing lies outside: zero is read there.
inline vec4 fetched(const BoundTexture& bound, ivec3 p, int lod) {
  if (bound.view == nullptr) return vec4(0, 0, 0, 1);
  if (static_cast<uint>(lod) >= static_cast<uint>(bound.view->levels)) return vec4(0);
  const TextureLevel& level = bound.view->level[lod];
  if (static_cast<uint>(p.x) >= static_cast<uint>(level.width) ||
      static_cast<uint>(p.y) >= static_cast<uint>(level.height) ||
      static_cast<uint>(p.z) >= static_cast<uint>(level.depth)) {
    return vec4(0);
  }
  const std::size_t texel =
      (static_cast<std::size_t>(p.z) * level.height + static_cast<std::size_t>(p.y)) * level.width + p.x;
  if (bound.view->is_float) {
    const float* rgba = static_cast<const float*>(level.texels) + 4 * texel;
    vec4 result(rgba[0], rgba[1], rgba[2], rgba[3]);
#ifdef SHADERTWIN_SHADOW
    if (const ShadowViews& shadows = bound.shadows; shadows.high != nullptr) {
      const auto at = [&](const TextureView* view, int i) {
        return static_cast<const float*>(view->level[lod].texels)[4 * texel + i];
      };
      for (int i = 0; i < 4; ++i) {
        const float low = at(shadows.low, i);
        result[i].exact = at(shadows.high, i);
        if (low != 0.0F) result[i].exact += low;
        result[i].origin = static_cast<uint>(at(shadows.origin, i));
      }
    }
#endif
    return result;
  }
  const std::uint8_t* rgba = static_cast<const std::uint8_t*>(level.texels) + 4 * texel;
  constexpr float scale = 1.0F / 255.0F;
  return vec4(static_cast<float>(rgba[0]) * scale, static_cast<float>(rgba[1]) * scale,
              static_cast<float>(rgba[2]) * scale, static_cast<float>(rgba[3]) * scale);
}

}  // namespace detail

// The four pixels of a quad share the level of its first, but for cubes: there each has its own.
inline Lod implicit_lod(const sampler2D& s, const Quad<vec2>& p, int /*lane*/) {
  return detail::lod_from_steps(s.bound, p, 0, true);
}
inline Lod implicit_lod(const sampler3D& s, const Quad<vec3>& p, int /*lane*/) {
  return detail::lod_from_steps(s.bound, p, 0, true);
}
inline Lod implicit_lod(const samplerCube& s, const Quad<vec3>& p, int lane) {
  return detail::lod_from_steps(s.bound, p, lane, false);
}

// --- GLSL's functions -------------------------------------------------------

inline ivec2 textureSize(const sampler2D& s, int lod) {
  return detail::size_of(s.bound, lod).xy();
}
inline ivec3 textureSize(const sampler3D& s, int lod) {
  return detail::size_of(s.bound, lod);
}
inline ivec2 textureSize(const samplerCube& s, int lod) {
  return detail::size_of(s.bound, lod).xy();
}

inline vec4 texelFetch(const sampler2D& s, ivec2 p, int lod) {
  return detail::fetched(s.bound, ivec3(p, 0), lod);
}
inline vec4 texelFetch(const sampler3D& s, ivec3 p, int lod) {
  return detail::fetched(s.bound, p, lod);
}
inline vec4 texelFetchOffset(const sampler2D& s, ivec2 p, int lod, ivec2 offset) {
  return texelFetch(s, p + offset, lod);
}
inline vec4 texelFetchOffset(const sampler3D& s, ivec3 p, int lod, ivec3 offset) {
  return texelFetch(s, p + offset, lod);
}

// texture, textureLod and textureGrad of one kind of sampler. `Lod` is what implicit_lod gave.
#define SHADERTWIN_SAMPLE(sampler, vector)                                    \
  inline vec4 texture(const sampler& s, vector p, Lod lod) {                  \
    return detail::sampled(s.bound, p, detail::request(lod));                 \
  }                                                                           \
  inline vec4 texture(const sampler& s, vector p, Lod lod, Float bias) {      \
    return detail::sampled(s.bound, p, detail::request(lod, bias));           \
  }                                                                           \
  inline vec4 textureLod(const sampler& s, vector p, Float level) {           \
    return detail::sampled(s.bound, p, detail::request(level));               \
  }                                                                           \
  inline vec4 textureGrad(const sampler& s, vector p, vector dx, vector dy) { \
    return detail::sampled(s.bound, p, detail::request(s.bound, p, dx, dy));  \
  }
SHADERTWIN_SAMPLE(sampler2D, vec2)
SHADERTWIN_SAMPLE(sampler3D, vec3)
SHADERTWIN_SAMPLE(samplerCube, vec3)
#undef SHADERTWIN_SAMPLE

#define SHADERTWIN_SAMPLE_OFFSET(sampler, vector, ivector, widened)                                 \
  inline vec4 textureOffset(const sampler& s, vector p, Lod lod, ivector offset) {                  \
    return detail::sampled(s.bound, p, detail::request(lod), widened);                              \
  }                                                                                                 \
  inline vec4 textureOffset(const sampler& s, vector p, Lod lod, ivector offset, Float bias) {      \
    return detail::sampled(s.bound, p, detail::request(lod, bias), widened);                        \
  }                                                                                                 \
  inline vec4 textureLodOffset(const sampler& s, vector p, Float level, ivector offset) {           \
    return detail::sampled(s.bound, p, detail::request(level), widened);                            \
  }                                                                                                 \
  inline vec4 textureGradOffset(const sampler& s, vector p, vector dx, vector dy, ivector offset) { \
    return detail::sampled(s.bound, p, detail::request(s.bound, p, dx, dy), widened);               \
  }
SHADERTWIN_SAMPLE_OFFSET(sampler2D, vec2, ivec2, ivec3(offset, 0))
SHADERTWIN_SAMPLE_OFFSET(sampler3D, vec3, ivec3, offset)
#undef SHADERTWIN_SAMPLE_OFFSET

// The coordinates of textureProj after its division, which Mesa makes a product with the reciprocal.
inline vec2 projected(const sampler2D& /*s*/, vec3 p) {
  return p.xy() * (Float(1) / p.z);
}
inline vec2 projected(const sampler2D& /*s*/, vec4 p) {
  return p.xy() * (Float(1) / p.w);
}
inline vec3 projected(const sampler3D& /*s*/, vec4 p) {
  return p.xyz() * (Float(1) / p.w);
}

#define SHADERTWIN_SAMPLE_PROJECTED(sampler, projective, vector, ivector)                                   \
  inline vec4 textureProj(const sampler& s, projective p, Lod lod) {                                        \
    return texture(s, projected(s, p), lod);                                                                \
  }                                                                                                         \
  inline vec4 textureProj(const sampler& s, projective p, Lod lod, Float bias) {                            \
    return texture(s, projected(s, p), lod, bias);                                                          \
  }                                                                                                         \
  inline vec4 textureProjLod(const sampler& s, projective p, Float level) {                                 \
    return textureLod(s, projected(s, p), level);                                                           \
  }                                                                                                         \
  inline vec4 textureProjGrad(const sampler& s, projective p, vector dx, vector dy) {                       \
    return textureGrad(s, projected(s, p), dx, dy);                                                         \
  }                                                                                                         \
  inline vec4 textureProjOffset(const sampler& s, projective p, Lod lod, ivector offset) {                  \
    return textureOffset(s, projected(s, p), lod, offset);                                                  \
  }                                                                                                         \
  inline vec4 textureProjOffset(const sampler& s, projective p, Lod lod, ivector offset, Float bias) {      \
    return textureOffset(s, projected(s, p), lod, offset, bias);                                            \
  }                                                                                                         \
  inline vec4 textureProjLodOffset(const sampler& s, projective p, Float level, ivector offset) {           \
    return textureLodOffset(s, projected(s, p), level, offset);                                             \
  }                                                                                                         \
  inline vec4 textureProjGradOffset(const sampler& s, projective p, vector dx, vector dy, ivector offset) { \
    return textureGradOffset(s, projected(s, p), dx, dy, offset);                                           \
  }
SHADERTWIN_SAMPLE_PROJECTED(sampler2D, vec3, vec2, ivec2)
SHADERTWIN_SAMPLE_PROJECTED(sampler2D, vec4, vec2, ivec2)
SHADERTWIN_SAMPLE_PROJECTED(sampler3D, vec4, vec3, ivec3)
#undef SHADERTWIN_SAMPLE_PROJECTED

}  // namespace shadertwin::glsl::inline SHADERTWIN_PRECISION

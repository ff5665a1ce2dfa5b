// The base of every shader that is emitted for packets: what GLSL gives the invocations of eight pixels, and
// the loop over the picture. The pixels of a packet are two 2x2 squares side by side, so that derivatives are
// differences of lanes.
#pragma once

#include <cstring>

#include "reference/glsl/packet_functions.h"
#include "reference/twin/invocation.h"

namespace shadertwin::glsl::packet {

// Lane i of a packet draws the pixel at (x + lane_x[i], y + lane_y[i]).
constexpr int packet_width = 4;
constexpr int packet_height = 2;
constexpr int lane_x[lanes] = {0, 1, 0, 1, 2, 3, 2, 3};
constexpr int lane_y[lanes] = {0, 0, 1, 1, 0, 0, 1, 1};

namespace implementation {

SHADERTWIN_INLINE Float along_x(Float a) {
  const detail::float8 right = __builtin_shufflevector(a.v, a.v, 1, 1, 3, 3, 5, 5, 7, 7);
  const detail::float8 left = __builtin_shufflevector(a.v, a.v, 0, 0, 2, 2, 4, 4, 6, 6);
  return Float(right - left);
}
SHADERTWIN_INLINE Float along_y(Float a) {
  const detail::float8 upper = __builtin_shufflevector(a.v, a.v, 2, 3, 2, 3, 6, 7, 6, 7);
  const detail::float8 lower = __builtin_shufflevector(a.v, a.v, 0, 1, 0, 1, 4, 5, 4, 5);
  return Float(upper - lower);
}
template <int N>
SHADERTWIN_INLINE glm::vec<N, Float> along_x(const glm::vec<N, Float>& a) {
  glm::vec<N, Float> result;
  for (int i = 0; i < N; ++i) result[i] = along_x(a[i]);
  return result;
}
template <int N>
SHADERTWIN_INLINE glm::vec<N, Float> along_y(const glm::vec<N, Float>& a) {
  glm::vec<N, Float> result;
  for (int i = 0; i < N; ++i) result[i] = along_y(a[i]);
  return result;
}

}  // namespace implementation

struct Invocation : Stoppable {
  vec4 gl_FragCoord{};
  Bool gl_FrontFacing = true;
  vec2 gl_PointCoord{};
  Float gl_FragDepth{};
  Bool alive__ = true;  // the lanes that have not been discarded

  // What does not vary has no slope.
  template <class T>
  Varying<T> dFdx(const T& value) {
    return implementation::along_x(make<Varying<T>>(value));
  }
  template <class T>
  Varying<T> dFdy(const T& value) {
    return implementation::along_y(make<Varying<T>>(value));
  }
  template <class T>
  Varying<T> fwidth(const T& value) {
    return abs(dFdx(value)) + abs(dFdy(value));
  }

  // Textures are read lane by lane, by those of the mask.
  template <class Sampler, class P, class... Bias>
  vec4 texture(Bool mask, const Sampler& s, const P& p, const Bias&... bias) {
    const Lods__ lods(s, [&](int i) { return lane__(p, i); });
    return each_lane__(mask,
                       [&](int i) { return glsl::texture(s, lane__(p, i), lods[i], lane__(bias, i)...); });
  }
  template <class Sampler, class P, class... Rest>
  vec4 textureOffset(Bool mask, const Sampler& s, const P& p, const Rest&... rest) {
    const Lods__ lods(s, [&](int i) { return lane__(p, i); });
    return each_lane__(
        mask, [&](int i) { return glsl::textureOffset(s, lane__(p, i), lods[i], lane__(rest, i)...); });
  }
  template <class Sampler, class P, class... Bias>
  vec4 textureProj(Bool mask, const Sampler& s, const P& p, const Bias&... bias) {
    const Lods__ lods(s, [&](int i) { return glsl::projected(s, lane__(p, i)); });
    return each_lane__(
        mask, [&](int i) { return glsl::textureProj(s, lane__(p, i), lods[i], lane__(bias, i)...); });
  }
  template <class Sampler, class P, class... Rest>
  vec4 textureProjOffset(Bool mask, const Sampler& s, const P& p, const Rest&... rest) {
    const Lods__ lods(s, [&](int i) { return glsl::projected(s, lane__(p, i)); });
    return each_lane__(
        mask, [&](int i) { return glsl::textureProjOffset(s, lane__(p, i), lods[i], lane__(rest, i)...); });
  }

  // Cubes, where a pixel beside a corner changes what is computed for all eight.
  template <class P, class... Bias>
  vec4 texture(Bool mask, const samplerCube& s, const P& p, const Bias&... bias) {
    const Lods__ lods(s, [&](int i) { return lane__(p, i); });
    return read_cube__(mask, s, p, [&](int i) { return glsl::detail::request(lods[i], lane__(bias, i)...); });
  }
  template <class P, class Level>
  vec4 textureLod(Bool mask, const samplerCube& s, const P& p, const Level& level) {
    return read_cube__(mask, s, p, [&](int i) { return glsl::detail::request(lane__(level, i)); });
  }
  template <class P, class X, class Y>
  vec4 textureGrad(Bool mask, const samplerCube& s, const P& p, const X& dx, const Y& dy) {
    return read_cube__(mask, s, p, [&](int i) {
      return glsl::detail::request(s.bound, lane__(p, i), lane__(dx, i), lane__(dy, i));
    });
  }

#define SHADERTWIN_READ(name)                                                                \
  template <class Sampler, class... Arguments>                                               \
  auto name(Bool mask, const Sampler& s, const Arguments&... arguments) {                    \
    return each_lane__(mask, [&](int i) { return glsl::name(s, lane__(arguments, i)...); }); \
  }
  SHADERTWIN_READ(textureLod)
  SHADERTWIN_READ(textureLodOffset)
  SHADERTWIN_READ(textureGrad)
  SHADERTWIN_READ(textureGradOffset)
  SHADERTWIN_READ(textureProjLod)
  SHADERTWIN_READ(textureProjLodOffset)
  SHADERTWIN_READ(textureProjGrad)
  SHADERTWIN_READ(textureProjGradOffset)
  SHADERTWIN_READ(texelFetch)
  SHADERTWIN_READ(texelFetchOffset)
  SHADERTWIN_READ(textureSize)
#undef SHADERTWIN_READ

 private:
  // The level of detail of each pixel.
  class Lods__ {
   public:
    template <class Sampler, class Coordinates>
    Lods__(const Sampler& s, const Coordinates& coordinates) {
      if (!needs_lod(s)) return;
      using P = decltype(coordinates(0));
      constexpr bool shared = !std::is_same_v<Sampler, samplerCube>;
      for (int first = 0; first < lanes; first += 4) {
        const Quad<P> quad{
            {coordinates(first), coordinates(first + 1), coordinates(first + 2), coordinates(first + 3)}};
        for (int i = 0; i < 4; ++i)
          lod_[first + i] = shared && i > 0 ? lod_[first] : implicit_lod(s, quad, i);
      }
    }
    const Lod& operator[](int lane) const { return lod_[lane]; }

   private:
    Lod lod_[lanes];
  };

  template <class P, class Request>
  static vec4 read_cube__(Bool mask, const samplerCube& s, const P& p, const Request& request) {
    if (s.bound.view == nullptr) return vec4(0.0F, 0.0F, 0.0F, 1.0F);
    LodRequest requests[lanes];
    unsigned corners = 0;
    // Pixels that do not take part count too: llvmpipe looks at what is left in their registers.
    for (int i = 0; i < lanes; ++i) {
      requests[i] = request(i);
      const auto at = glsl::detail::coordinates(lane__(p, i));
      corners |= s.bound.sampling->corners(*s.bound.view, s.bound.state, at.v, requests[i]);
    }
    return each_lane__(mask, [&](int i) {
      requests[i].corners = corners;
      return glsl::detail::sampled(s.bound, lane__(p, i), requests[i]);
    });
  }
};

// Draws the pixels of a request. Shader is the emitted structure.
template <class Shader>
class PixelLoop {
 public:
  using Output = vec4 (*)(const Shader&);

  PixelLoop(const twin::Request& request, Output output) : request_(request), output_(output) {
    shader_.bind_uniforms__(UniformReader(request));
    shader_.stop__ = request.stop;
  }

  void run() {
    const FlushDenormals denormals;
    // Packets stand on multiples of their size, whatever the rectangle.
    for (int y = request_.y0 & -packet_height; y < request_.y1; y += packet_height) {
      if (twin::is_set(*request_.stop)) return;
      for (int x = request_.x0 & -packet_width; x < request_.x1; x += packet_width) packet(x, y);
    }
  }

 private:
  void packet(int x0, int y0) {
    Bool inside;
    for (int i = 0; i < lanes; ++i) {
      const int x = x0 + lane_x[i];
      const int y = y0 + lane_y[i];
      shader_.gl_FragCoord.x.v[i] = static_cast<float>(x) + 0.5F;
      shader_.gl_FragCoord.y.v[i] = static_cast<float>(y) + 0.5F;
      set_lane__(inside, i, x >= request_.x0 && x < request_.x1 && y >= request_.y0 && y < request_.y1);
    }
    shader_.gl_FragCoord.z = 0.5F;
    shader_.gl_FragCoord.w = 1.0F;
    // Pixels beside the rectangle are drawn only for their neighbours' derivatives.
    const Bool running = request_.quads ? Bool(true) : inside;
    shader_.alive__ = running;
    const bool have_colors = completes<Shader>([&] {
      shader_.initialise__(running);
      shader_.main(running);
    });
    if (!have_colors) return;
    const vec4 color = output_(shader_);
    for (unsigned left = bits_of__(inside && shader_.alive__); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      float* pixel = static_cast<float*>(request_.pixels) +
                     (y0 + lane_y[i] - request_.y0) * request_.row_pitch +
                     std::ptrdiff_t{4} * (x0 + lane_x[i] - request_.x0);
      for (int c = 0; c < 4; ++c) pixel[c] = color[c].v[i];
    }
  }

  const twin::Request& request_;
  Output output_;
  Shader shader_;
};

// Any output as RGBA.
inline vec4 as_pixel(const vec4& color) {
  return color;
}
inline vec4 as_pixel(const vec3& color) {
  return vec4(color, 1.0F);
}
inline vec4 as_pixel(const vec2& color) {
  return vec4(color, 0.0F, 1.0F);
}
inline vec4 as_pixel(Float color) {
  return vec4(color, 0.0F, 0.0F, 1.0F);
}

// What a shader leaves unwritten, as glsl::unwritten has it.
template <class T>
SHADERTWIN_INLINE void unwritten(Bool mask, T& variable) {
  T value;
  glsl::unwritten(value);
  set__(mask, variable, value);
}

}  // namespace shadertwin::glsl::packet

#define SHADERTWIN_EXPORT_PACKETS(output)                                                            \
  extern "C" __attribute__((visibility("default"))) void shadertwin_describe(                        \
      shadertwin::twin::Description* description) {                                                  \
    using namespace shadertwin::glsl::packet;                                                        \
    *description = {shadertwin::twin::abi_version, false, Shader::uses_derivatives__,                \
                    Shader::uses_implicit_lod__,                                                     \
                    sizeof(PixelLoop<Shader>) + Shader::components__ * sizeof(Float)};               \
  }                                                                                                  \
  extern "C" __attribute__((visibility("default"))) void shadertwin_render(                          \
      const shadertwin::twin::Request* request) {                                                    \
    using namespace shadertwin::glsl::packet;                                                        \
    PixelLoop<Shader>(*request, [](const Shader& shader) { return as_pixel(shader.output); }).run(); \
  }

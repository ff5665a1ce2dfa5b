// The base of every emitted shader: what GLSL gives an invocation, and the loop over pixels.
#pragma once

#include <cstring>

#include "reference/glsl/denormals.h"
#include "reference/glsl/glsl.h"
#include "reference/twin/abi.h"
#include "reference/twin/checks.h"
#include "reference/twin/shadows.h"
#include "reference/twin/unwritten.h"

namespace shadertwin::glsl {

// Ends an invocation.
struct Stopped {};

// What lets an invocation end from anywhere within: discard, or a loop that has to stop.
struct Stoppable {
  [[noreturn, gnu::cold, gnu::noinline]] static void stop_invocation__() { throw Stopped{}; }

  void loop_guard__() {
    if ((++rounds__ & 0xfffu) == 0 && twin::is_set(*stop__)) stop_invocation__();
  }

  const bool* stop__ = nullptr;
  unsigned rounds__ = 0;
};

// Whether `run` came to its end.
template <class Shader, class Run>
bool completes(const Run& run) {
  if constexpr (Shader::uses_stop__) {
    try {
      run();
    } catch (const Stopped&) {
      return false;
    }
  } else {
    run();
  }
  return true;
}

struct Invocation : twin::Checks, twin::Shadows, Stoppable {
  vec4 gl_FragCoord{};
  bool gl_FrontFacing = true;
  vec2 gl_PointCoord{};
  Float gl_FragDepth{};

  // `place` tells the quad's pixels whether they have come to the same point of the shader.
  template <class T>
  T dFdx(T value, int place = __builtin_LINE()) {
    return glsl::dFdx(exchange__(value, place), own_lane__);
  }
  template <class T>
  T dFdy(T value, int place = __builtin_LINE()) {
    return glsl::dFdy(exchange__(value, place), own_lane__);
  }
  template <class T>
  T fwidth(T value, int place = __builtin_LINE()) {
    return glsl::fwidth(exchange__(value, place), own_lane__);
  }

  template <class Sampler, class P>
  vec4 texture(const Sampler& s, P p, int place = __builtin_LINE()) {
    return glsl::texture(s, p, lod__(s, p, place));
  }
  template <class Sampler, class P>
  vec4 texture(const Sampler& s, P p, Float bias, int place = __builtin_LINE()) {
    return glsl::texture(s, p, lod__(s, p, place), bias);
  }
  template <class Sampler, class P, class Offset>
  vec4 textureOffset(const Sampler& s, P p, Offset offset, int place = __builtin_LINE()) {
    return glsl::textureOffset(s, p, lod__(s, p, place), offset);
  }
  template <class Sampler, class P, class Offset>
  vec4 textureOffset(const Sampler& s, P p, Offset offset, Float bias, int place = __builtin_LINE()) {
    return glsl::textureOffset(s, p, lod__(s, p, place), offset, bias);
  }
  template <class Sampler, class P>
  vec4 textureProj(const Sampler& s, P p, int place = __builtin_LINE()) {
    return glsl::textureProj(s, p, lod__(s, glsl::projected(s, p), place));
  }
  template <class Sampler, class P>
  vec4 textureProj(const Sampler& s, P p, Float bias, int place = __builtin_LINE()) {
    return glsl::textureProj(s, p, lod__(s, glsl::projected(s, p), place), bias);
  }
  template <class Sampler, class P, class Offset>
  vec4 textureProjOffset(const Sampler& s, P p, Offset offset, int place = __builtin_LINE()) {
    return glsl::textureProjOffset(s, p, lod__(s, glsl::projected(s, p), place), offset);
  }
  template <class Sampler, class P, class Offset>
  vec4 textureProjOffset(const Sampler& s, P p, Offset offset, Float bias, int place = __builtin_LINE()) {
    return glsl::textureProjOffset(s, p, lod__(s, glsl::projected(s, p), place), offset, bias);
  }

  // What follows is the twin's, not the shader's: names end in two underscores, so that they hide none of it.

  template <class Shader>
  friend class PixelLoop;

 private:
  template <class Sampler, class P>
  Lod lod__(const Sampler& s, const P& p, int place) {
    if (quad__ == nullptr || !needs_lod(s)) return Lod{};
    return implicit_lod(s, exchange__(p, place), own_lane__);
  }

  // The value that each pixel of the quad has here. One that did not come here (it has ended, or took another
  // branch) counts as if the value changed evenly over the square.
  template <class T>
  Quad<T> exchange__(const T& value, int place) {
    Quad<T> quad{{value, value, value, value}};
    if (quad__ == nullptr) return quad;
    static_assert(sizeof(T) <= twin::QuadExchange::max_bytes);
    std::memcpy(quad__->waiting[own_lane__].value, &value, sizeof value);
    quad__->waiting[own_lane__].place = place;
    quad__->wait(quad__, own_lane__);
#if defined(SHADERTWIN_CHECK) || defined(SHADERTWIN_SHADOW)
    resume__();
#endif
    const auto met = [&](int lane) { return (quad__->met_lanes >> lane & 1u) != 0; };
    for (int i = 0; i < 4; ++i) {
      if (met(i)) std::memcpy(static_cast<void*>(&quad.v[i]), quad__->met[i].value, sizeof value);
    }
    for (int i = 0; i < 4; ++i) {
      if (!met(i) && met(i ^ 1) && met(i ^ 2) && met(i ^ 3))
        quad.v[i] = quad.v[i ^ 1] + quad.v[i ^ 2] - quad.v[i ^ 3];
    }
    return quad;
  }

  twin::QuadExchange* quad__ = nullptr;
  int own_lane__ = 0;
};

// Gives a uniform its value.
class UniformReader {
 public:
  explicit UniformReader(const twin::Request& request) : request_(request) {}

  template <class T>
  void operator()(const char* name, T& target) const {
    for (int i = 0; i < request_.uniform_count; ++i) {
      if (std::strcmp(request_.uniforms[i].name, name) == 0) return read(request_.uniforms[i], target);
    }
  }

 private:
  using Kind = twin::UniformValue::Kind;

  static double number(const twin::UniformValue& value, int i) {
    if (i >= value.count) return 0;
    // No conditional expression: its type would be float, which keeps no int beyond 2^24.
    if (value.kind == Kind::int32) return static_cast<const int*>(value.data)[i];
    return static_cast<double>(static_cast<const float*>(value.data)[i]);
  }

  template <class T>
  static void read_at(const twin::UniformValue& value, int& at, T& target) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, Float>) {
      target = static_cast<T>(number(value, at++));
    } else {
      for (int i = 0; i < target.length(); ++i) read_at(value, at, target[i]);
    }
  }

  template <class T>
  static constexpr bool is_sampler =
      std::is_same_v<T, sampler2D> || std::is_same_v<T, sampler3D> || std::is_same_v<T, samplerCube>;

  // Arrays of samplers, which nothing sets.
  template <class T>
  static constexpr bool are_samplers() {
    if constexpr (is_sampler<T>)
      return true;
    else if constexpr (!std::is_arithmetic_v<T> && !std::is_same_v<T, Float>)
      return are_samplers<std::remove_cvref_t<decltype(std::declval<T&>()[0])>>();
    else
      return false;
  }

  template <class T>
  static void read(const twin::UniformValue& value, T& target) {
    if constexpr (is_sampler<T>) {
      if (value.kind == Kind::sampler) target = *static_cast<const T*>(value.data);
    } else if constexpr (are_samplers<T>()) {
      return;
    } else if (value.kind != Kind::sampler) {
      int at = 0;
      read_at(value, at, target);
    }
  }

  const twin::Request& request_;
};

// Draws the pixels of a request. Shader is the emitted structure.
template <class Shader>
class PixelLoop {
 public:
  using Output = vec4 (*)(const Shader&);

  PixelLoop(const twin::Request& request, Output output) : request_(request), output_(output) {
    for (Shader& shader : shaders_) {
      shader.bind_uniforms__(UniformReader(request));
      shader.stop__ = request.stop;
      if (!request.quads) break;
    }
  }

  void run() {
    [[maybe_unused]] const Denormals denormals;
    const int step = request_.quads ? 2 : 1;
    // Quads stand on even pixels, whatever the rectangle.
    for (int y = request_.y0 & ~(step - 1); y < request_.y1; y += step) {
      if (twin::is_set(*request_.stop)) return;
      for (int x = request_.x0 & ~(step - 1); x < request_.x1; x += step) {
        x_ = x;
        y_ = y;
        draw();
#ifdef SHADERTWIN_SHADOW
        again_ = false;
        for (const Shader& shader : shaders_) again_ = again_ || shader.has_parted__();
        if (again_) draw();
        again_ = false;
#endif
      }
    }
  }

 private:
  void draw() {
    if (request_.quads)
      request_.run_quad(
          request_.quad_runner, &exchange_,
          [](void* self, int lane) { static_cast<PixelLoop*>(self)->pixel(lane); }, this);
    else
      pixel(0);
  }

  void pixel(int lane) {
    [[maybe_unused]] const Denormals denormals;  // a lane has a floating-point state of its own
    Shader& shader = shaders_[lane];
    const int x = x_ + lane % 2;
    const int y = y_ + lane / 2;
    shader.gl_FragCoord =
        vec4(static_cast<Float>(x) + Float(0.5), static_cast<Float>(y) + Float(0.5), 0.5, 1);
    shader.quad__ = request_.quads ? &exchange_ : nullptr;
    shader.own_lane__ = lane;
    const bool inside = x >= request_.x0 && x < request_.x1 && y >= request_.y0 && y < request_.y1;
#ifdef SHADERTWIN_CHECK
    shader.start__(inside ? request_.log : nullptr, x, y);
#endif
#ifdef SHADERTWIN_SHADOW
    shader.start__(inside ? request_.shadow_log : nullptr, x, y, again_);
#endif
    const bool has_color = completes<Shader>([&] {
      shader.initialise__();
      shader.main();
    });
#ifdef SHADERTWIN_SHADOW
    if (again_) return compare(lane, has_color);
    drawn_[lane] = {has_color, output_(shader)};
#endif
    if (!has_color || !inside) return;
    Float* pixel = static_cast<Float*>(request_.pixels) + (y - request_.y0) * request_.row_pitch +
                   std::ptrdiff_t{4} * (x - request_.x0);
    const vec4 color = output_(shader);
    for (int i = 0; i < 4; ++i) pixel[i] = color[i];
  }

#ifdef SHADERTWIN_SHADOW
  // What double makes of its own decisions, beside what the lane has drawn.
  void compare(int lane, bool has_color) {
    double error = has_color != drawn_[lane].has_color ? 1.0 : 0.0;
    const vec4 color = output_(shaders_[lane]);
    const int channels = request_.shadow_log->is_picture ? 3 : 4;  // alpha is not seen
    for (int i = 0; i < channels && has_color && drawn_[lane].has_color; ++i)
      error = std::max(error, twin::picture_error(request_.shadow_log->is_picture,
                                                  drawn_[lane].color[i].value, color[i].exact));
    shaders_[lane].moved__(error);
    const int x = x_ + lane % 2 - request_.x0;
    const int y = y_ + lane / 2 - request_.y0;
    const bool inside = x >= 0 && x < request_.x1 - request_.x0 && y >= 0 && y < request_.y1 - request_.y0;
    if (inside) request_.shadow_log->moved[y * (request_.row_pitch / 4) + x] = static_cast<float>(error);
  }

  struct Drawn {
    bool has_color = false;
    vec4 color{};
  };
  Drawn drawn_[twin::QuadExchange::lanes];
  bool again_ = false;  // pixels run once more, as double decides
#endif

#ifdef SHADERTWIN_DOUBLE
  struct Denormals {};
#else
  using Denormals = FlushDenormals;
#endif

  const twin::Request& request_;
  Output output_;
  Shader shaders_[twin::QuadExchange::lanes];
  twin::QuadExchange exchange_;
  int x_ = 0;
  int y_ = 0;
};

// Any output as RGBA.
inline vec4 as_pixel(const vec4& color) {
  return color;
}
inline vec4 as_pixel(const vec3& color) {
  return vec4(color, 1);
}
inline vec4 as_pixel(const vec2& color) {
  return vec4(color, 0, 1);
}
inline vec4 as_pixel(Float color) {
  return vec4(color, 0, 0, 1);
}

}  // namespace shadertwin::glsl

#ifdef SHADERTWIN_SHADOW
static_assert(sizeof(shadertwin::glsl::Float) == sizeof(shadertwin::twin::ShadowNumber));
#define SHADERTWIN_PLACES Shader::places__, static_cast<int>(std::size(Shader::places__))
#else
#define SHADERTWIN_PLACES nullptr, 0
#endif

#define SHADERTWIN_EXPORT(output)                                                                    \
  extern "C" __attribute__((visibility("default"))) void shadertwin_describe(                        \
      shadertwin::twin::Description* description) {                                                  \
    using namespace shadertwin::glsl;                                                                \
    *description = {shadertwin::twin::abi_version,                                                   \
                    sizeof(Float) == sizeof(double),                                                 \
                    Shader::uses_derivatives__,                                                      \
                    Shader::uses_implicit_lod__,                                                     \
                    sizeof(PixelLoop<Shader>) + Shader::components__ * sizeof(Float),                \
                    SHADERTWIN_PLACES};                                                              \
  }                                                                                                  \
  extern "C" __attribute__((visibility("default"))) void shadertwin_render(                          \
      const shadertwin::twin::Request* request) {                                                    \
    using namespace shadertwin::glsl;                                                                \
    PixelLoop<Shader>(*request, [](const Shader& shader) { return as_pixel(shader.output); }).run(); \
  }

// How an invocation of a checking twin ends before its time: what it had on the stack is cleared away.
#include "reference/twin/invocation.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace shadertwin::glsl {
namespace {

int alive = 0;

struct Counted {
  Counted() { ++alive; }
  ~Counted() { --alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  std::vector<float> memory = std::vector<float>(100);  // a leak, for a sanitizer
};

struct Stopping : Invocation {
  static constexpr bool uses_stop__ = true;
  vec4 color{};

  template <class Bind>
  void bind_uniforms__(Bind&& /*bind*/) {}
  void initialise__() {}
};

// Discards the even columns, in a function of a function.
struct Discarding : Stopping {
  void inner() {
    const Counted counted;
    if (static_cast<int>(gl_FragCoord.x) % 2 == 0) stop_invocation__();
    color = vec4(2.0F);
  }
  void main() {
    const Counted counted;
    inner();
  }
};

// Never ends by itself.
struct Endless : Stopping {
  static inline bool stop = false;
  void main() {
    const Counted counted;
    stop = true;
    for (;;) loop_guard__();
  }
};

template <class Shader>
std::array<float, 16> draw(const bool& stop) {
  std::array<float, 16> pixels;
  pixels.fill(-1.0F);
  twin::Request request;
  request.x1 = 4;
  request.y1 = 1;
  request.pixels = pixels.data();
  request.row_pitch = 16;
  request.stop = &stop;
  alive = 0;
  PixelLoop<Shader>(request, [](const Shader& shader) { return as_pixel(shader.color); }).run();
  return pixels;
}

TEST(Stopping, ADiscardLeavesThePixelAndNothingOnTheStack) {
  const bool stop = false;
  const auto pixels = draw<Discarding>(stop);
  for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(pixels[4 * x], x % 2 == 0 ? -1.0F : 2.0F) << x;
  EXPECT_EQ(alive, 0);
}

TEST(Stopping, AnEndlessLoopEndsWhenTheTimeIsOver) {
  const auto pixels = draw<Endless>(Endless::stop);
  EXPECT_EQ(pixels[0], -1.0F);
  EXPECT_EQ(alive, 0);
}

}  // namespace
}  // namespace shadertwin::glsl

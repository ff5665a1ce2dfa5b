#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  array<vec2, 2> shared_{};
  Int total{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
    unwritten(active, shared_);
    total = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 53;

#line 3 "tests/emit/shaders/packets.glsl"
  Float f(Bool active, Float x) {
#line 3 "tests/emit/shaders/packets.glsl"
    return x * 0.5f;
#line 3 "tests/emit/shaders/packets.glsl"
  }
#line 31 "twin.cpp"

#line 4 "tests/emit/shaders/packets.glsl"
  float f(Bool active, int x) {
#line 4 "tests/emit/shaders/packets.glsl"
    return float(x) + 10.0f;
#line 4 "tests/emit/shaders/packets.glsl"
  }
#line 39 "twin.cpp"

#line 5 "tests/emit/shaders/packets.glsl"
  Float map(Bool active, Float x) {
#line 5 "tests/emit/shaders/packets.glsl"
    return 1.0f - 0.05f * x;
#line 5 "tests/emit/shaders/packets.glsl"
  }
#line 47 "twin.cpp"

#line 6 "tests/emit/shaders/packets.glsl"
  void two(Bool active, Float& a, Float& b) {
#line 6 "tests/emit/shaders/packets.glsl"
    unwritten(active, b);
#line 6 "tests/emit/shaders/packets.glsl"
    set__(active, a, 3.0f);
#line 6 "tests/emit/shaders/packets.glsl"
    set__(active, b, 4.0f);
#line 6 "tests/emit/shaders/packets.glsl"
  }
#line 59 "twin.cpp"

#line 7 "tests/emit/shaders/packets.glsl"
  void set(Bool active, vec2& a) {
#line 7 "tests/emit/shaders/packets.glsl"
    set__(active, a, vec2(7.0f, 8.0f));
#line 7 "tests/emit/shaders/packets.glsl"
  }
#line 67 "twin.cpp"

#line 9 "tests/emit/shaders/packets.glsl"
  float touch(Bool active, Int i) {
#line 9 "tests/emit/shaders/packets.glsl"
    const Int tmp = i;
#line 9 "tests/emit/shaders/packets.glsl"
    vec2 element = at(shared_, tmp);
#line 9 "tests/emit/shaders/packets.glsl"
    set__(active, element.y, 5.0f);
#line 9 "tests/emit/shaders/packets.glsl"
    put__(active, shared_, tmp, element);
#line 9 "tests/emit/shaders/packets.glsl"
    return 1.0f;
#line 9 "tests/emit/shaders/packets.glsl"
  }
#line 83 "twin.cpp"

#line 10 "tests/emit/shaders/packets.glsl"
  float gone(Bool active, Float x) {
#line 10 "tests/emit/shaders/packets.glsl"
    if (Bool active_2 = active && (x > 14.0f); any__(active_2)) {
#line 10 "tests/emit/shaders/packets.glsl"
      alive__ = alive__ && !active_2;
#line 10 "tests/emit/shaders/packets.glsl"
      mask_out__(active_2, active);
#line 10 "tests/emit/shaders/packets.glsl"
    }
#line 10 "tests/emit/shaders/packets.glsl"
    if (none__(active)) return {};
#line 10 "tests/emit/shaders/packets.glsl"
    return 1.0f;
#line 10 "tests/emit/shaders/packets.glsl"
  }
#line 101 "twin.cpp"

#line 12 "tests/emit/shaders/packets.glsl"
  Int grow(Bool active) {
#line 12 "tests/emit/shaders/packets.glsl"
    set__(active, total, total + 3);
#line 12 "tests/emit/shaders/packets.glsl"
    return total;
#line 12 "tests/emit/shaders/packets.glsl"
  }
#line 111 "twin.cpp"

#line 13 "tests/emit/shaders/packets.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 13 "tests/emit/shaders/packets.glsl"
    unwritten(active, color);
    Int k = make<Int>(p.x) & 1;
    Float n = 0.0f;
    Float d;
#line 16 "tests/emit/shaders/packets.glsl"
    {
#line 16 "tests/emit/shaders/packets.glsl"
      Bool loop = active;
#line 16 "tests/emit/shaders/packets.glsl"
      int i = 0;
#line 16 "tests/emit/shaders/packets.glsl"
      for (;;) {
#line 16 "tests/emit/shaders/packets.glsl"
        const bool tmp = i++ < 10;
#line 16 "tests/emit/shaders/packets.glsl"
        Bool tmp_2 = tmp;
#line 16 "tests/emit/shaders/packets.glsl"
        if (tmp) {
#line 16 "tests/emit/shaders/packets.glsl"
          set__(loop, d, map(loop, p.x + float(i)));
#line 16 "tests/emit/shaders/packets.glsl"
          tmp_2 = d > 0.5f;
#line 16 "tests/emit/shaders/packets.glsl"
        }
#line 16 "tests/emit/shaders/packets.glsl"
        loop = loop && (tmp_2);
#line 16 "tests/emit/shaders/packets.glsl"
        if (none__(loop)) break;
#line 16 "tests/emit/shaders/packets.glsl"
        Bool active_2 = loop;
#line 16 "tests/emit/shaders/packets.glsl"
        set__(active_2, n, n + 1.0f);
#line 16 "tests/emit/shaders/packets.glsl"
      }
#line 16 "tests/emit/shaders/packets.glsl"
    }
    int m = 0;
    const bool tmp_3 = m++ < 2;
#line 18 "tests/emit/shaders/packets.glsl"
    bool tmp_4 = tmp_3;
#line 18 "tests/emit/shaders/packets.glsl"
    if (!tmp_3) {
#line 18 "tests/emit/shaders/packets.glsl"
      tmp_4 = (m += 4) > 0;
#line 18 "tests/emit/shaders/packets.glsl"
    }
#line 18 "tests/emit/shaders/packets.glsl"
    bool b = tmp_4;
#line 20 "tests/emit/shaders/packets.glsl"
    array<vec2, 2> e;
#line 20 "tests/emit/shaders/packets.glsl"
    e[1] = vec2(0.0f);
#line 20 "tests/emit/shaders/packets.glsl"
    e[0] = e[1];
    const Int tmp_5 = k;
#line 21 "tests/emit/shaders/packets.glsl"
    const Int tmp_6 = k;
#line 21 "tests/emit/shaders/packets.glsl"
    vec2 element = at(e, tmp_5);
#line 21 "tests/emit/shaders/packets.glsl"
    Float tmp_7 = element.x;
#line 21 "tests/emit/shaders/packets.glsl"
    vec2 element_2 = at(e, tmp_6);
#line 21 "tests/emit/shaders/packets.glsl"
    Float tmp_8 = element_2.y;
#line 21 "tests/emit/shaders/packets.glsl"
    two(active, tmp_7, tmp_8);
#line 21 "tests/emit/shaders/packets.glsl"
    element = at(e, tmp_5);
#line 21 "tests/emit/shaders/packets.glsl"
    set__(active, element.x, tmp_7);
#line 21 "tests/emit/shaders/packets.glsl"
    put__(active, e, tmp_5, element);
#line 21 "tests/emit/shaders/packets.glsl"
    element_2 = at(e, tmp_6);
#line 21 "tests/emit/shaders/packets.glsl"
    set__(active, element_2.y, tmp_8);
#line 21 "tests/emit/shaders/packets.glsl"
    put__(active, e, tmp_6, element_2);
    set__(active, shared_[1], vec2(0.0f));
#line 22 "tests/emit/shaders/packets.glsl"
    set__(active, shared_[0], shared_[1]);
    const Int tmp_9 = k;
#line 23 "tests/emit/shaders/packets.glsl"
    const float tmp_10 = touch(active, k);
#line 23 "tests/emit/shaders/packets.glsl"
    vec2 element_3 = at(shared_, tmp_9);
#line 23 "tests/emit/shaders/packets.glsl"
    set__(active, element_3.x, tmp_10);
#line 23 "tests/emit/shaders/packets.glsl"
    put__(active, shared_, tmp_9, element_3);
    const Int tmp_11 = k;
#line 24 "tests/emit/shaders/packets.glsl"
    const float tmp_12 = touch(active, 1 - k);
#line 24 "tests/emit/shaders/packets.glsl"
    vec2 element_4 = at(shared_, tmp_11);
#line 24 "tests/emit/shaders/packets.glsl"
    set__(active, element_4.x, element_4.x + tmp_12);
#line 24 "tests/emit/shaders/packets.glsl"
    put__(active, shared_, tmp_11, element_4);
#line 26 "tests/emit/shaders/packets.glsl"
    array<vec2, 3> a;
#line 26 "tests/emit/shaders/packets.glsl"
    a[2] = vec2(0.0f);
#line 26 "tests/emit/shaders/packets.glsl"
    a[1] = a[2];
#line 26 "tests/emit/shaders/packets.glsl"
    a[0] = a[1];
    int j = 0;
    const int tmp_13 = j++;
#line 28 "tests/emit/shaders/packets.glsl"
    vec2 tmp_14 = a[tmp_13].xy();
#line 28 "tests/emit/shaders/packets.glsl"
    set(active, tmp_14);
#line 28 "tests/emit/shaders/packets.glsl"
    set__(active, swizzle<0, 1>(a[tmp_13]), tmp_14);
    const int tmp_15 = j++;
#line 29 "tests/emit/shaders/packets.glsl"
    a[tmp_15].x = a[tmp_15].x + 1.0f;
#line 31 "tests/emit/shaders/packets.glsl"
    array<Float, 3> grid;
#line 31 "tests/emit/shaders/packets.glsl"
    grid[2] = p.x;
#line 31 "tests/emit/shaders/packets.glsl"
    grid[1] = grid[2];
#line 31 "tests/emit/shaders/packets.glsl"
    grid[0] = grid[1];
    int h = 0;
    const int tmp_16 = h++;
#line 33 "tests/emit/shaders/packets.glsl"
    grid[tmp_16] = grid[tmp_16] + 1.0f;
    const int tmp_17 = h++;
#line 34 "tests/emit/shaders/packets.glsl"
    grid[tmp_17] = grid[tmp_17] + 2.0f;
#line 36 "tests/emit/shaders/packets.glsl"
    array<vec2, 2> c;
#line 36 "tests/emit/shaders/packets.glsl"
    c[1] = p;
#line 36 "tests/emit/shaders/packets.glsl"
    c[0] = c[1];
    int s = 0;
    const Int tmp_18 = k;
#line 38 "tests/emit/shaders/packets.glsl"
    const int tmp_19 = s++;
#line 38 "tests/emit/shaders/packets.glsl"
    vec2 element_5 = at(c, tmp_18);
#line 38 "tests/emit/shaders/packets.glsl"
    at(element_5, tmp_19) = at(element_5, tmp_19) + 1.0f;
#line 38 "tests/emit/shaders/packets.glsl"
    put__(active, c, tmp_18, element_5);
    int i = 0;
    const Bool tmp_20 = float(i++) < p.x - 4.0f;
#line 40 "tests/emit/shaders/packets.glsl"
    Float r = select__(tmp_20, Float(float(i)), Float(9.0f));
    const Int tmp_21 = grow(active);
#line 41 "tests/emit/shaders/packets.glsl"
    set__(active, total, total + tmp_21);
    Float sum = 0.0f;
    {
#line 43 "tests/emit/shaders/packets.glsl"
      Bool loop = active;
#line 43 "tests/emit/shaders/packets.glsl"
      for (;;) {
#line 43 "tests/emit/shaders/packets.glsl"
        loop = loop && (sum < 3.0f);
#line 43 "tests/emit/shaders/packets.glsl"
        if (none__(loop)) break;
#line 43 "tests/emit/shaders/packets.glsl"
        Bool active_2 = loop;
#line 43 "tests/emit/shaders/packets.glsl"
        const float tmp_22 = gone(active_2, p.x);
#line 43 "tests/emit/shaders/packets.glsl"
        keep__(alive__, active_2, loop, active);
#line 43 "tests/emit/shaders/packets.glsl"
        const float tmp_23 = tmp_22;
#line 43 "tests/emit/shaders/packets.glsl"
        set__(active_2, sum, sum + tmp_23);
#line 43 "tests/emit/shaders/packets.glsl"
      }
#line 43 "tests/emit/shaders/packets.glsl"
    }
#line 43 "tests/emit/shaders/packets.glsl"
    if (none__(active)) return;
    set__(active, color, vec4(n + float(m) * 16.0f + ((b) ? 100.0f : 0.0f) + f(active, p.x) + f(active, Float(0.5f)) + f(active, 1) * 1000.0f, at(e, k).x + 10.0f * at(e, k).y + a[0].x + a[0].y * 3.0f + a[1].x * 100.0f + float(j) * 1000.0f, shared_[0].x + shared_[0].y * 2.0f + shared_[1].x * 4.0f + shared_[1].y * 8.0f + make<Float>(total) * 100.0f, grid[0] + grid[1] * 3.0f + float(h) * 100.0f + at(c, k).x * 7.0f + float(s) * 1000.0f + r * 0.5f + sum));
#line 44 "tests/emit/shaders/packets.glsl"
  }
#line 302 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    keep__(alive__, active);
    if (none__(active)) return;
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)

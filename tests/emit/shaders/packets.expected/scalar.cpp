#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  array<vec2, 2> shared_{};
  int total{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    unwritten(shared_);
    total = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = true;
  static constexpr std::size_t components__ = 53;

#line 3 "tests/emit/shaders/packets.glsl"
  Float f(Float x) {
#line 3 "tests/emit/shaders/packets.glsl"
    return x * 0.5f;
#line 3 "tests/emit/shaders/packets.glsl"
  }
#line 31 "twin.cpp"

#line 4 "tests/emit/shaders/packets.glsl"
  Float f(int x) {
#line 4 "tests/emit/shaders/packets.glsl"
    return Float(x) + 10.0f;
#line 4 "tests/emit/shaders/packets.glsl"
  }
#line 39 "twin.cpp"

#line 5 "tests/emit/shaders/packets.glsl"
  Float map(Float x) {
#line 5 "tests/emit/shaders/packets.glsl"
    return 1.0f - 0.05f * x;
#line 5 "tests/emit/shaders/packets.glsl"
  }
#line 47 "twin.cpp"

#line 6 "tests/emit/shaders/packets.glsl"
  void two(Float& a, Float& b) {
#line 6 "tests/emit/shaders/packets.glsl"
    unwritten(b);
#line 6 "tests/emit/shaders/packets.glsl"
    a = 3.0f;
#line 6 "tests/emit/shaders/packets.glsl"
    b = 4.0f;
#line 6 "tests/emit/shaders/packets.glsl"
  }
#line 59 "twin.cpp"

#line 7 "tests/emit/shaders/packets.glsl"
  void set(vec2& a) {
#line 7 "tests/emit/shaders/packets.glsl"
    a = vec2(7.0f, 8.0f);
#line 7 "tests/emit/shaders/packets.glsl"
  }
#line 67 "twin.cpp"

#line 9 "tests/emit/shaders/packets.glsl"
  Float touch(int i) {
#line 9 "tests/emit/shaders/packets.glsl"
    shared_[i].y = 5.0f;
#line 9 "tests/emit/shaders/packets.glsl"
    return 1.0f;
#line 9 "tests/emit/shaders/packets.glsl"
  }
#line 77 "twin.cpp"

#line 10 "tests/emit/shaders/packets.glsl"
  Float gone(Float x) {
#line 10 "tests/emit/shaders/packets.glsl"
    if (x > 14.0f) {
#line 10 "tests/emit/shaders/packets.glsl"
      stop_invocation__();
#line 10 "tests/emit/shaders/packets.glsl"
    }
#line 10 "tests/emit/shaders/packets.glsl"
    return 1.0f;
#line 10 "tests/emit/shaders/packets.glsl"
  }
#line 91 "twin.cpp"

#line 12 "tests/emit/shaders/packets.glsl"
  int grow() {
#line 12 "tests/emit/shaders/packets.glsl"
    total += 3;
#line 12 "tests/emit/shaders/packets.glsl"
    return total;
#line 12 "tests/emit/shaders/packets.glsl"
  }
#line 101 "twin.cpp"

#line 13 "tests/emit/shaders/packets.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 13 "tests/emit/shaders/packets.glsl"
    unwritten(color);
    int k = make<int>(p.x) & 1;
    Float n = 0.0f;
    Float d;
#line 16 "tests/emit/shaders/packets.glsl"
    for (int i = 0; i++ < 10 && (d = map(p.x + Float(i))) > 0.5f;) {
#line 16 "tests/emit/shaders/packets.glsl"
      n += 1.0f;
#line 16 "tests/emit/shaders/packets.glsl"
    }
    int m = 0;
    bool b = m++ < 2 || (m += 4) > 0;
#line 20 "tests/emit/shaders/packets.glsl"
    array<vec2, 2> e;
#line 20 "tests/emit/shaders/packets.glsl"
    e[0] = e[1] = vec2(0.0f);
    Float tmp;
#line 21 "tests/emit/shaders/packets.glsl"
    Float tmp_2;
#line 21 "tests/emit/shaders/packets.glsl"
    two(tmp, tmp_2);
#line 21 "tests/emit/shaders/packets.glsl"
    e[k].x = tmp;
#line 21 "tests/emit/shaders/packets.glsl"
    e[k].y = tmp_2;
    shared_[0] = shared_[1] = vec2(0.0f);
    shared_[k].x = touch(k);
    shared_[k].x += touch(1 - k);
#line 26 "tests/emit/shaders/packets.glsl"
    array<vec2, 3> a;
#line 26 "tests/emit/shaders/packets.glsl"
    a[0] = a[1] = a[2] = vec2(0.0f);
    int j = 0;
    const int tmp_3 = j++;
#line 28 "tests/emit/shaders/packets.glsl"
    vec2 tmp_4;
#line 28 "tests/emit/shaders/packets.glsl"
    set(tmp_4);
#line 28 "tests/emit/shaders/packets.glsl"
    swizzle<0, 1>(a[tmp_3]) = tmp_4;
    const int tmp_5 = j++;
#line 29 "tests/emit/shaders/packets.glsl"
    a[tmp_5].x++;
#line 31 "tests/emit/shaders/packets.glsl"
    array<Float, 3> grid;
#line 31 "tests/emit/shaders/packets.glsl"
    grid[0] = grid[1] = grid[2] = p.x;
    int h = 0;
    const int tmp_6 = h++;
#line 33 "tests/emit/shaders/packets.glsl"
    grid[tmp_6]++;
    const int tmp_7 = h++;
#line 34 "tests/emit/shaders/packets.glsl"
    grid[tmp_7] += 2.0f;
#line 36 "tests/emit/shaders/packets.glsl"
    array<vec2, 2> c;
#line 36 "tests/emit/shaders/packets.glsl"
    c[0] = c[1] = p;
    int s = 0;
    const int tmp_8 = k;
#line 38 "tests/emit/shaders/packets.glsl"
    const int tmp_9 = s++;
#line 38 "tests/emit/shaders/packets.glsl"
    at(c[tmp_8], tmp_9) += 1.0f;
    int i = 0;
    Float r = Float(i++) < p.x - 4.0f ? Float(i) : 9.0f;
    total += grow();
    Float sum = 0.0f;
    while (sum < 3.0f) {
#line 43 "tests/emit/shaders/packets.glsl"
      sum += gone(p.x);
#line 43 "tests/emit/shaders/packets.glsl"
    }
    color = vec4(n + Float(m) * 16.0f + (b ? 100.0f : 0.0f) + f(p.x) + f(0.5f) + f(1) * 1000.0f, e[k].x + 10.0f * e[k].y + a[0].x + a[0].y * 3.0f + a[1].x * 100.0f + Float(j) * 1000.0f, shared_[0].x + shared_[0].y * 2.0f + shared_[1].x * 4.0f + shared_[1].y * 8.0f + Float(total) * 100.0f, grid[0] + grid[1] * 3.0f + Float(h) * 100.0f + c[k].x * 7.0f + Float(s) * 1000.0f + r * 0.5f + sum);
#line 44 "tests/emit/shaders/packets.glsl"
  }
#line 182 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)

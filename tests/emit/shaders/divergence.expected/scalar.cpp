#include "reference/twin/invocation.h"

namespace shadertwin::glsl {
namespace {

struct Item {
  vec2 at_;
  int tag;
  bool on;
  bool operator==(const Item&) const = default;
};

struct Bag {
  array<Item, 3> items;
  mat2 turn;
  bool operator==(const Bag&) const = default;
};

const array<bool, 3> odd = array<bool, 3>{{false, true, true}};
const array<Float, 6> grid = array<Float, 6>{{0.5f, 1.5f, 2.5f, 3.5f, 4.5f, 5.5f}};
const array<Item, 2> first = array<Item, 2>{{Item{vec2(1.0f, 2.0f), 3, true}, Item{vec2(4.0f, 5.0f), 6, false}}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  int steps{};

  void initialise__() {
    unwritten(shadertoy_out_color);
    steps = 0;
  }
  template <class Bind>
  void bind_uniforms__(Bind&& bind) {
  }
  static constexpr bool uses_derivatives__ = false;
  static constexpr bool uses_implicit_lod__ = false;
  static constexpr bool uses_stop__ = false;
  static constexpr std::size_t components__ = 120;

#line 9 "tests/emit/shaders/divergence.glsl"
  int early(int n) {
    for (int i = 0; i < 20; i++) {
      if (i * i > n) {
#line 11 "tests/emit/shaders/divergence.glsl"
        return i;
#line 11 "tests/emit/shaders/divergence.glsl"
      }
      for (int j = 0;; j++) {
        if (j > i) {
#line 13 "tests/emit/shaders/divergence.glsl"
          break;
#line 13 "tests/emit/shaders/divergence.glsl"
        }
        if ((j + n) % 5 == 4) {
#line 14 "tests/emit/shaders/divergence.glsl"
          return 100 + j;
#line 14 "tests/emit/shaders/divergence.glsl"
        }
        steps++;
#line 15 "tests/emit/shaders/divergence.glsl"
      }
#line 15 "tests/emit/shaders/divergence.glsl"
    }
#line 18 "tests/emit/shaders/divergence.glsl"
    return -1;
#line 18 "tests/emit/shaders/divergence.glsl"
  }
#line 68 "twin.cpp"

#line 20 "tests/emit/shaders/divergence.glsl"
  bool count(int& n) {
#line 20 "tests/emit/shaders/divergence.glsl"
    n++;
#line 20 "tests/emit/shaders/divergence.glsl"
    steps += 2;
#line 20 "tests/emit/shaders/divergence.glsl"
    return (n & 1) == 0;
#line 20 "tests/emit/shaders/divergence.glsl"
  }
#line 80 "twin.cpp"

#line 21 "tests/emit/shaders/divergence.glsl"
  int route(int n) {
    int sum = 0;
    for (int i = 0; i < 7; i++) {
      switch ((n + i) % 6) {
        case 0:
#line 25 "tests/emit/shaders/divergence.glsl"
        {
#line 25 "tests/emit/shaders/divergence.glsl"
          sum += 1;
#line 25 "tests/emit/shaders/divergence.glsl"
        }
#line 25 "tests/emit/shaders/divergence.glsl"
        [[fallthrough]];
        case 1:
#line 26 "tests/emit/shaders/divergence.glsl"
        {
#line 26 "tests/emit/shaders/divergence.glsl"
          sum += 10;
#line 26 "tests/emit/shaders/divergence.glsl"
          break;
#line 26 "tests/emit/shaders/divergence.glsl"
        }
#line 26 "tests/emit/shaders/divergence.glsl"
        [[fallthrough]];
        case 2:
#line 27 "tests/emit/shaders/divergence.glsl"
        {
#line 27 "tests/emit/shaders/divergence.glsl"
          if (n > 9) {
#line 27 "tests/emit/shaders/divergence.glsl"
            continue;
#line 27 "tests/emit/shaders/divergence.glsl"
          }
#line 27 "tests/emit/shaders/divergence.glsl"
          sum += 100;
#line 27 "tests/emit/shaders/divergence.glsl"
          break;
#line 27 "tests/emit/shaders/divergence.glsl"
        }
#line 27 "tests/emit/shaders/divergence.glsl"
        [[fallthrough]];
        case 5:
#line 28 "tests/emit/shaders/divergence.glsl"
        {
#line 28 "tests/emit/shaders/divergence.glsl"
          if (n == 3) {
#line 28 "tests/emit/shaders/divergence.glsl"
            return sum + 100000;
#line 28 "tests/emit/shaders/divergence.glsl"
          }
#line 28 "tests/emit/shaders/divergence.glsl"
        }
#line 28 "tests/emit/shaders/divergence.glsl"
        [[fallthrough]];
        default:
#line 29 "tests/emit/shaders/divergence.glsl"
        {
#line 29 "tests/emit/shaders/divergence.glsl"
          sum += 1000;
#line 29 "tests/emit/shaders/divergence.glsl"
        }
#line 29 "tests/emit/shaders/divergence.glsl"
      }
#line 31 "tests/emit/shaders/divergence.glsl"
      sum += i;
      if (sum > 4000 + n) {
#line 32 "tests/emit/shaders/divergence.glsl"
        break;
#line 32 "tests/emit/shaders/divergence.glsl"
      }
#line 32 "tests/emit/shaders/divergence.glsl"
    }
#line 34 "tests/emit/shaders/divergence.glsl"
    return sum;
#line 34 "tests/emit/shaders/divergence.glsl"
  }
#line 159 "twin.cpp"

#line 36 "tests/emit/shaders/divergence.glsl"
  Float walk(vec2 p, int& rounds) {
#line 36 "tests/emit/shaders/divergence.glsl"
    unwritten(rounds);
    Float x = p.x;
    rounds = 0;
#line 44 "tests/emit/shaders/divergence.glsl"
    do {
#line 40 "tests/emit/shaders/divergence.glsl"
      rounds++;
      if (mod(Float(rounds) + p.y, 3.0f) < 1.0f) {
#line 41 "tests/emit/shaders/divergence.glsl"
        continue;
#line 41 "tests/emit/shaders/divergence.glsl"
      }
      x *= 0.75f;
      if (x < 0.4f) {
#line 43 "tests/emit/shaders/divergence.glsl"
        return -x;
#line 43 "tests/emit/shaders/divergence.glsl"
      }
    } while (rounds < 9 && (x > 1.0f || [&]() -> bool { int tmp = steps; const bool tmp_2 = count(tmp); steps = tmp; return tmp_2; }()));
    while (true) {
#line 45 "tests/emit/shaders/divergence.glsl"
      if (x > 8.0f + p.y) {
#line 45 "tests/emit/shaders/divergence.glsl"
        break;
#line 45 "tests/emit/shaders/divergence.glsl"
      }
#line 45 "tests/emit/shaders/divergence.glsl"
      x = x * 1.5f + 1.0f;
#line 45 "tests/emit/shaders/divergence.glsl"
      if (rounds > 6) {
#line 45 "tests/emit/shaders/divergence.glsl"
        x = -3.0f;
#line 45 "tests/emit/shaders/divergence.glsl"
        break;
#line 45 "tests/emit/shaders/divergence.glsl"
      }
#line 45 "tests/emit/shaders/divergence.glsl"
    }
    return x;
#line 46 "tests/emit/shaders/divergence.glsl"
  }
#line 205 "twin.cpp"

#line 48 "tests/emit/shaders/divergence.glsl"
  void put(Bag& bag, int i, int j) {
    at(bag.items[i].at_, j) += 2.0f;
    bag.items[i].tag = i * 3 + j;
    bag.items[(i + 1) % 3].on = odd[i % 3];
    at(at(bag.turn, j), i & 1) -= 0.25f;
    if (i == 1) {
#line 53 "tests/emit/shaders/divergence.glsl"
      swizzle<1, 0>(bag.items[j].at_) = vec2(Float(j), grid[i + 4 * j]);
#line 53 "tests/emit/shaders/divergence.glsl"
      return;
#line 53 "tests/emit/shaders/divergence.glsl"
    }
    swizzle<0, 1>(at(bag.turn, i & 1)) *= 2.0f;
#line 54 "tests/emit/shaders/divergence.glsl"
  }
#line 223 "twin.cpp"

#line 56 "tests/emit/shaders/divergence.glsl"
  void mainImage(vec4& color, vec2 p) {
#line 56 "tests/emit/shaders/divergence.glsl"
    unwritten(color);
    ivec2 q = make<ivec2>(p);
    int n = q.x * 3 + q.y;
    int a = early(n);
#line 59 "tests/emit/shaders/divergence.glsl"
    int b = route(n % 13);
#line 59 "tests/emit/shaders/divergence.glsl"
    int r = n % 4;
#line 59 "tests/emit/shaders/divergence.glsl"
    int c = 0;
    Float w = walk(p * 0.5f, r);
    Bag bag = Bag{array<Item, 3>{{Item{vec2(1.0f, 2.0f), 3, true}, Item{vec2(4.0f, 5.0f), 6, false}, first[n & 1]}}, mat2(1.0f, 0.0f, 0.0f, 1.0f)};
    put(bag, n % 3, n / 2 % 2);
    if (n % 7 > 2 && count(c) || n % 5 == 1 && !count(c)) {
#line 63 "tests/emit/shaders/divergence.glsl"
      c += 10;
#line 63 "tests/emit/shaders/divergence.glsl"
    } else {
#line 63 "tests/emit/shaders/divergence.glsl"
      if (n % 2 == 0) {
#line 63 "tests/emit/shaders/divergence.glsl"
        c -= 5;
#line 63 "tests/emit/shaders/divergence.glsl"
      }
#line 63 "tests/emit/shaders/divergence.glsl"
    }
    c += n % 3 == 0 ? [&]() -> int { count(c); return c * 2; }() : n % 3 == 1 ? make<int>(grid[n % 9 - 1]) : -c;
    vec4 v = vec4(p, 1.0f, 2.0f);
    at(v, n % 6 - 1) = 7.0f;
#line 68 "tests/emit/shaders/divergence.glsl"
    array<int, 2> more;
#line 68 "tests/emit/shaders/divergence.glsl"
    more[0] = 5;
#line 68 "tests/emit/shaders/divergence.glsl"
    more[1] = n;
    more[n & 1]++;
    int i = 0;
    for (; i < 9; i++) {
#line 71 "tests/emit/shaders/divergence.glsl"
      if (i == n % 11) {
#line 71 "tests/emit/shaders/divergence.glsl"
        break;
#line 71 "tests/emit/shaders/divergence.glsl"
      }
#line 71 "tests/emit/shaders/divergence.glsl"
      if (i % 2 == 0) {
#line 71 "tests/emit/shaders/divergence.glsl"
        continue;
#line 71 "tests/emit/shaders/divergence.glsl"
      }
#line 71 "tests/emit/shaders/divergence.glsl"
      more[i & 1] += i;
#line 71 "tests/emit/shaders/divergence.glsl"
    }
    if (n % 8 < 6) {
#line 72 "tests/emit/shaders/divergence.glsl"
      if (first[n % 3] == Item{vec2(4.0f, 5.0f), 6, false}) {
#line 72 "tests/emit/shaders/divergence.glsl"
        c += 1000;
#line 72 "tests/emit/shaders/divergence.glsl"
      }
#line 72 "tests/emit/shaders/divergence.glsl"
      if (bag.items[0] != Item{vec2(1.0f, 2.0f), 3, true}) {
#line 72 "tests/emit/shaders/divergence.glsl"
        c += 2000;
#line 72 "tests/emit/shaders/divergence.glsl"
      }
#line 72 "tests/emit/shaders/divergence.glsl"
    }
    Item some = bag.items[(n + 1) % 3];
    color = vec4(Float(a + b), w + Float(r), dot(some.at_, bag.turn * v.xy()) + Float(some.tag) + v.z * v.w, Float(c + i * 10 + more[0] * 100 + more[1] + steps + (some.on ? 5000 : 0)));
#line 74 "tests/emit/shaders/divergence.glsl"
  }
#line 301 "twin.cpp"

  void main() {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(shadertoy_color, gl_FragCoord.xy());
    shadertoy_out_color = shadertoy_color;
  }

};

}  // namespace
}  // namespace shadertwin::glsl

SHADERTWIN_EXPORT(shadertoy_out_color)

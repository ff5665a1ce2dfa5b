#include "reference/twin/packet_invocation.h"

namespace shadertwin::glsl::packet {
namespace {

struct Item {
  vec2 at_;
  Int tag;
  Bool on;
  friend void set__(Bool m, Item& to, const Item& from) { set__(m, to.at_, from.at_); set__(m, to.tag, from.tag); set__(m, to.on, from.on); }
  friend Bool same__(const Item& a, const Item& b) { return Bool(true) && same__(a.at_, b.at_) && same__(a.tag, b.tag) && same__(a.on, b.on); }
};

struct Bag {
  array<Item, 3> items;
  mat2 turn;
  friend void set__(Bool m, Bag& to, const Bag& from) { set__(m, to.items, from.items); set__(m, to.turn, from.turn); }
  friend Bool same__(const Bag& a, const Bag& b) { return Bool(true) && same__(a.items, b.items) && same__(a.turn, b.turn); }
};

const array<Bool, 3> odd = array<Bool, 3>{{false, true, true}};
const array<float, 6> grid = array<float, 6>{{0.5f, 1.5f, 2.5f, 3.5f, 4.5f, 5.5f}};
const array<Item, 2> first = array<Item, 2>{{Item{vec2(1.0f, 2.0f), 3, true}, Item{vec2(4.0f, 5.0f), 6, false}}};

struct Shader : Invocation {
  vec4 shadertoy_out_color{};
  Int steps{};

  void initialise__(Bool active) {
    unwritten(active, shadertoy_out_color);
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
  Int early(Bool active, Int n) {
#line 9 "tests/emit/shaders/divergence.glsl"
    Int result{};
    {
#line 10 "tests/emit/shaders/divergence.glsl"
      Bool loop = active;
#line 10 "tests/emit/shaders/divergence.glsl"
      int i = 0;
#line 10 "tests/emit/shaders/divergence.glsl"
      for (;; i++) {
#line 10 "tests/emit/shaders/divergence.glsl"
        loop = loop && (i < 20);
#line 10 "tests/emit/shaders/divergence.glsl"
        if (none__(loop)) break;
#line 10 "tests/emit/shaders/divergence.glsl"
        Bool active_2 = loop;
        if (Bool active_3 = active_2 && (i * i > n); any__(active_3)) {
#line 11 "tests/emit/shaders/divergence.glsl"
          set__(active_3, result, i);
#line 11 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop, active);
#line 11 "tests/emit/shaders/divergence.glsl"
        }
#line 11 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
        {
#line 12 "tests/emit/shaders/divergence.glsl"
          Bool loop_2 = active_2;
#line 12 "tests/emit/shaders/divergence.glsl"
          int j = 0;
#line 12 "tests/emit/shaders/divergence.glsl"
          for (;; j++) {
#line 12 "tests/emit/shaders/divergence.glsl"
            if (none__(loop_2)) break;
#line 12 "tests/emit/shaders/divergence.glsl"
            Bool active_3 = loop_2;
            if (j > i) {
#line 13 "tests/emit/shaders/divergence.glsl"
              mask_out__(active_3, loop_2);
#line 13 "tests/emit/shaders/divergence.glsl"
            }
#line 13 "tests/emit/shaders/divergence.glsl"
            if (none__(active_3)) continue;
            if (Bool active_4 = active_3 && ((j + n) % 5 == 4); any__(active_4)) {
#line 14 "tests/emit/shaders/divergence.glsl"
              set__(active_4, result, 100 + j);
#line 14 "tests/emit/shaders/divergence.glsl"
              mask_out__(active_4, active_3, loop_2, active_2, loop, active);
#line 14 "tests/emit/shaders/divergence.glsl"
            }
#line 14 "tests/emit/shaders/divergence.glsl"
            if (none__(active_3)) continue;
            set__(active_3, steps, steps + 1);
#line 15 "tests/emit/shaders/divergence.glsl"
          }
#line 15 "tests/emit/shaders/divergence.glsl"
        }
#line 15 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 15 "tests/emit/shaders/divergence.glsl"
      }
#line 15 "tests/emit/shaders/divergence.glsl"
    }
#line 15 "tests/emit/shaders/divergence.glsl"
    if (none__(active)) return result;
#line 18 "tests/emit/shaders/divergence.glsl"
    set__(active, result, -1);
#line 18 "tests/emit/shaders/divergence.glsl"
    return result;
#line 18 "tests/emit/shaders/divergence.glsl"
  }
#line 114 "twin.cpp"

#line 20 "tests/emit/shaders/divergence.glsl"
  Bool count(Bool active, Int& n) {
#line 20 "tests/emit/shaders/divergence.glsl"
    set__(active, n, n + 1);
#line 20 "tests/emit/shaders/divergence.glsl"
    set__(active, steps, steps + 2);
#line 20 "tests/emit/shaders/divergence.glsl"
    return (n & 1) == 0;
#line 20 "tests/emit/shaders/divergence.glsl"
  }
#line 126 "twin.cpp"

#line 21 "tests/emit/shaders/divergence.glsl"
  Int route(Bool active, Int n) {
#line 21 "tests/emit/shaders/divergence.glsl"
    Int result{};
    Int sum = 0;
    {
#line 23 "tests/emit/shaders/divergence.glsl"
      Bool loop = active;
#line 23 "tests/emit/shaders/divergence.glsl"
      int i = 0;
#line 23 "tests/emit/shaders/divergence.glsl"
      for (;; i++) {
#line 23 "tests/emit/shaders/divergence.glsl"
        loop = loop && (i < 7);
#line 23 "tests/emit/shaders/divergence.glsl"
        if (none__(loop)) break;
#line 23 "tests/emit/shaders/divergence.glsl"
        Bool active_2 = loop;
        {
#line 24 "tests/emit/shaders/divergence.glsl"
          const Int selector = (n + i) % 6;
#line 24 "tests/emit/shaders/divergence.glsl"
          Bool active_3 = false;
#line 24 "tests/emit/shaders/divergence.glsl"
          active_3 = active_3 || (active_2 && (selector == 0));
#line 24 "tests/emit/shaders/divergence.glsl"
          if (any__(active_3)) {
            set__(active_3, sum, sum + 1);
#line 25 "tests/emit/shaders/divergence.glsl"
          }
#line 25 "tests/emit/shaders/divergence.glsl"
          active_3 = active_3 || (active_2 && (selector == 1));
#line 25 "tests/emit/shaders/divergence.glsl"
          if (any__(active_3)) {
            set__(active_3, sum, sum + 10);
#line 26 "tests/emit/shaders/divergence.glsl"
            mask_out__(active_3);
#line 26 "tests/emit/shaders/divergence.glsl"
          }
#line 26 "tests/emit/shaders/divergence.glsl"
          active_3 = active_3 || (active_2 && (selector == 2));
#line 26 "tests/emit/shaders/divergence.glsl"
          if (any__(active_3)) {
            if (Bool active_4 = active_3 && (n > 9); any__(active_4)) {
#line 27 "tests/emit/shaders/divergence.glsl"
              mask_out__(active_4, active_3, active_2);
#line 27 "tests/emit/shaders/divergence.glsl"
            }
#line 27 "tests/emit/shaders/divergence.glsl"
            set__(active_3, sum, sum + 100);
#line 27 "tests/emit/shaders/divergence.glsl"
            mask_out__(active_3);
#line 27 "tests/emit/shaders/divergence.glsl"
          }
#line 27 "tests/emit/shaders/divergence.glsl"
          active_3 = active_3 || (active_2 && (selector == 5));
#line 27 "tests/emit/shaders/divergence.glsl"
          if (any__(active_3)) {
            if (Bool active_4 = active_3 && (n == 3); any__(active_4)) {
#line 28 "tests/emit/shaders/divergence.glsl"
              set__(active_4, result, sum + 100000);
#line 28 "tests/emit/shaders/divergence.glsl"
              mask_out__(active_4, active_3, active_2, loop, active);
#line 28 "tests/emit/shaders/divergence.glsl"
            }
#line 28 "tests/emit/shaders/divergence.glsl"
          }
#line 28 "tests/emit/shaders/divergence.glsl"
          active_3 = active_3 || (active_2 && (!(selector == 0 || selector == 1 || selector == 2 || selector == 5)));
#line 28 "tests/emit/shaders/divergence.glsl"
          if (any__(active_3)) {
            set__(active_3, sum, sum + 1000);
#line 29 "tests/emit/shaders/divergence.glsl"
          }
#line 29 "tests/emit/shaders/divergence.glsl"
        }
#line 29 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 31 "tests/emit/shaders/divergence.glsl"
        set__(active_2, sum, sum + i);
        if (Bool active_3 = active_2 && (sum > 4000 + n); any__(active_3)) {
#line 32 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop);
#line 32 "tests/emit/shaders/divergence.glsl"
        }
#line 32 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 32 "tests/emit/shaders/divergence.glsl"
      }
#line 32 "tests/emit/shaders/divergence.glsl"
    }
#line 32 "tests/emit/shaders/divergence.glsl"
    if (none__(active)) return result;
#line 34 "tests/emit/shaders/divergence.glsl"
    set__(active, result, sum);
#line 34 "tests/emit/shaders/divergence.glsl"
    return result;
#line 34 "tests/emit/shaders/divergence.glsl"
  }
#line 227 "twin.cpp"

#line 36 "tests/emit/shaders/divergence.glsl"
  Float walk(Bool active, vec2 p, Int& rounds) {
#line 36 "tests/emit/shaders/divergence.glsl"
    unwritten(active, rounds);
#line 36 "tests/emit/shaders/divergence.glsl"
    Float result{};
    Float x = p.x;
    set__(active, rounds, 0);
#line 44 "tests/emit/shaders/divergence.glsl"
    {
#line 44 "tests/emit/shaders/divergence.glsl"
      Bool loop = active;
#line 44 "tests/emit/shaders/divergence.glsl"
      do {
#line 44 "tests/emit/shaders/divergence.glsl"
        Bool active_2 = loop;
#line 40 "tests/emit/shaders/divergence.glsl"
        set__(active_2, rounds, rounds + 1);
        if (Bool active_3 = active_2 && (mod(make<Float>(rounds) + p.y, Float(3.0f)) < 1.0f); any__(active_3)) {
#line 41 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2);
#line 41 "tests/emit/shaders/divergence.glsl"
        }
        set__(active_2, x, x * 0.75f);
        if (Bool active_3 = active_2 && (x < 0.4f); any__(active_3)) {
#line 43 "tests/emit/shaders/divergence.glsl"
          set__(active_3, result, -x);
#line 43 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop, active);
#line 43 "tests/emit/shaders/divergence.glsl"
        }
        const Bool tmp = rounds < 9;
#line 44 "tests/emit/shaders/divergence.glsl"
        Bool tmp_2 = tmp;
#line 44 "tests/emit/shaders/divergence.glsl"
        if (Bool active_2 = loop && tmp; any__(active_2)) {
#line 44 "tests/emit/shaders/divergence.glsl"
          const Bool tmp_3 = x > 1.0f;
#line 44 "tests/emit/shaders/divergence.glsl"
          Bool tmp_4 = tmp_3;
#line 44 "tests/emit/shaders/divergence.glsl"
          if (Bool active_3 = active_2 && !tmp_3; any__(active_3)) {
#line 44 "tests/emit/shaders/divergence.glsl"
            Int tmp_5 = steps;
#line 44 "tests/emit/shaders/divergence.glsl"
            const Bool tmp_6 = count(active_3, tmp_5);
#line 44 "tests/emit/shaders/divergence.glsl"
            set__(active_3, steps, tmp_5);
#line 44 "tests/emit/shaders/divergence.glsl"
            set__(active_3, tmp_4, tmp_6);
#line 44 "tests/emit/shaders/divergence.glsl"
          }
#line 44 "tests/emit/shaders/divergence.glsl"
          set__(active_2, tmp_2, tmp_4);
#line 44 "tests/emit/shaders/divergence.glsl"
        }
#line 44 "tests/emit/shaders/divergence.glsl"
        loop = loop && (tmp_2);
#line 44 "tests/emit/shaders/divergence.glsl"
      } while (any__(loop));
#line 44 "tests/emit/shaders/divergence.glsl"
    }
#line 44 "tests/emit/shaders/divergence.glsl"
    if (none__(active)) return result;
    {
#line 45 "tests/emit/shaders/divergence.glsl"
      Bool loop = active;
#line 45 "tests/emit/shaders/divergence.glsl"
      for (;;) {
#line 45 "tests/emit/shaders/divergence.glsl"
        loop = loop && (true);
#line 45 "tests/emit/shaders/divergence.glsl"
        if (none__(loop)) break;
#line 45 "tests/emit/shaders/divergence.glsl"
        Bool active_2 = loop;
#line 45 "tests/emit/shaders/divergence.glsl"
        if (Bool active_3 = active_2 && (x > 8.0f + p.y); any__(active_3)) {
#line 45 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop);
#line 45 "tests/emit/shaders/divergence.glsl"
        }
#line 45 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 45 "tests/emit/shaders/divergence.glsl"
        set__(active_2, x, x * 1.5f + 1.0f);
#line 45 "tests/emit/shaders/divergence.glsl"
        if (Bool active_3 = active_2 && (rounds > 6); any__(active_3)) {
#line 45 "tests/emit/shaders/divergence.glsl"
          set__(active_3, x, -3.0f);
#line 45 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop);
#line 45 "tests/emit/shaders/divergence.glsl"
        }
#line 45 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 45 "tests/emit/shaders/divergence.glsl"
      }
#line 45 "tests/emit/shaders/divergence.glsl"
    }
#line 45 "tests/emit/shaders/divergence.glsl"
    if (none__(active)) return result;
    set__(active, result, x);
#line 46 "tests/emit/shaders/divergence.glsl"
    return result;
#line 46 "tests/emit/shaders/divergence.glsl"
  }
#line 335 "twin.cpp"

#line 48 "tests/emit/shaders/divergence.glsl"
  void put(Bool active, Bag& bag, Int i, Int j) {
    const Int tmp = i;
#line 49 "tests/emit/shaders/divergence.glsl"
    const Int tmp_2 = j;
#line 49 "tests/emit/shaders/divergence.glsl"
    Item element = at(bag.items, tmp);
#line 49 "tests/emit/shaders/divergence.glsl"
    Float element_2 = at(element.at_, tmp_2);
#line 49 "tests/emit/shaders/divergence.glsl"
    set__(active, element_2, element_2 + 2.0f);
#line 49 "tests/emit/shaders/divergence.glsl"
    put__(active, element.at_, tmp_2, element_2);
#line 49 "tests/emit/shaders/divergence.glsl"
    put__(active, bag.items, tmp, element);
    const Int tmp_3 = i;
#line 50 "tests/emit/shaders/divergence.glsl"
    Item element_3 = at(bag.items, tmp_3);
#line 50 "tests/emit/shaders/divergence.glsl"
    set__(active, element_3.tag, i * 3 + j);
#line 50 "tests/emit/shaders/divergence.glsl"
    put__(active, bag.items, tmp_3, element_3);
    const Int tmp_4 = (i + 1) % 3;
#line 51 "tests/emit/shaders/divergence.glsl"
    Item element_4 = at(bag.items, tmp_4);
#line 51 "tests/emit/shaders/divergence.glsl"
    set__(active, element_4.on, at(odd, i % 3));
#line 51 "tests/emit/shaders/divergence.glsl"
    put__(active, bag.items, tmp_4, element_4);
    const Int tmp_5 = j;
#line 52 "tests/emit/shaders/divergence.glsl"
    const Int tmp_6 = i & 1;
#line 52 "tests/emit/shaders/divergence.glsl"
    vec2 element_5 = at(bag.turn, tmp_5);
#line 52 "tests/emit/shaders/divergence.glsl"
    Float element_6 = at(element_5, tmp_6);
#line 52 "tests/emit/shaders/divergence.glsl"
    set__(active, element_6, element_6 - 0.25f);
#line 52 "tests/emit/shaders/divergence.glsl"
    put__(active, element_5, tmp_6, element_6);
#line 52 "tests/emit/shaders/divergence.glsl"
    put__(active, bag.turn, tmp_5, element_5);
    if (Bool active_2 = active && (i == 1); any__(active_2)) {
#line 53 "tests/emit/shaders/divergence.glsl"
      const Int tmp_7 = j;
#line 53 "tests/emit/shaders/divergence.glsl"
      Item element_7 = at(bag.items, tmp_7);
#line 53 "tests/emit/shaders/divergence.glsl"
      set__(active_2, swizzle<1, 0>(element_7.at_), vec2(make<Float>(j), at(grid, i + 4 * j)));
#line 53 "tests/emit/shaders/divergence.glsl"
      put__(active_2, bag.items, tmp_7, element_7);
#line 53 "tests/emit/shaders/divergence.glsl"
      mask_out__(active_2, active);
#line 53 "tests/emit/shaders/divergence.glsl"
    }
#line 53 "tests/emit/shaders/divergence.glsl"
    if (none__(active)) return;
    const Int tmp_8 = i & 1;
#line 54 "tests/emit/shaders/divergence.glsl"
    vec2 element_8 = at(bag.turn, tmp_8);
#line 54 "tests/emit/shaders/divergence.glsl"
    set__(active, swizzle<0, 1>(element_8), element_8.xy() * 2.0f);
#line 54 "tests/emit/shaders/divergence.glsl"
    put__(active, bag.turn, tmp_8, element_8);
#line 54 "tests/emit/shaders/divergence.glsl"
  }
#line 403 "twin.cpp"

#line 56 "tests/emit/shaders/divergence.glsl"
  void mainImage(Bool active, vec4& color, vec2 p) {
#line 56 "tests/emit/shaders/divergence.glsl"
    unwritten(active, color);
    ivec2 q = make<ivec2>(p);
    Int n = q.x * 3 + q.y;
    Int a = early(active, n);
#line 59 "tests/emit/shaders/divergence.glsl"
    Int b = route(active, n % 13);
#line 59 "tests/emit/shaders/divergence.glsl"
    Int r = n % 4;
#line 59 "tests/emit/shaders/divergence.glsl"
    Int c = 0;
    Float w = walk(active, p * 0.5f, r);
    Bag bag = Bag{array<Item, 3>{{Item{vec2(1.0f, 2.0f), 3, true}, Item{vec2(4.0f, 5.0f), 6, false}, at(first, n & 1)}}, make<mat2>(uniform::mat2(1.0f, 0.0f, 0.0f, 1.0f))};
    put(active, bag, n % 3, n / 2 % 2);
    const Bool tmp = n % 7 > 2;
#line 63 "tests/emit/shaders/divergence.glsl"
    Bool tmp_2 = tmp;
#line 63 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && tmp; any__(active_2)) {
#line 63 "tests/emit/shaders/divergence.glsl"
      set__(active_2, tmp_2, count(active_2, c));
#line 63 "tests/emit/shaders/divergence.glsl"
    }
#line 63 "tests/emit/shaders/divergence.glsl"
    const Bool tmp_3 = tmp_2;
#line 63 "tests/emit/shaders/divergence.glsl"
    Bool tmp_4 = tmp_3;
#line 63 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && !tmp_3; any__(active_2)) {
#line 63 "tests/emit/shaders/divergence.glsl"
      const Bool tmp_5 = n % 5 == 1;
#line 63 "tests/emit/shaders/divergence.glsl"
      Bool tmp_6 = tmp_5;
#line 63 "tests/emit/shaders/divergence.glsl"
      if (Bool active_3 = active_2 && tmp_5; any__(active_3)) {
#line 63 "tests/emit/shaders/divergence.glsl"
        set__(active_3, tmp_6, !count(active_3, c));
#line 63 "tests/emit/shaders/divergence.glsl"
      }
#line 63 "tests/emit/shaders/divergence.glsl"
      set__(active_2, tmp_4, tmp_6);
#line 63 "tests/emit/shaders/divergence.glsl"
    }
#line 63 "tests/emit/shaders/divergence.glsl"
    const Bool condition = tmp_4;
#line 63 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && condition; any__(active_2)) {
#line 63 "tests/emit/shaders/divergence.glsl"
      set__(active_2, c, c + 10);
#line 63 "tests/emit/shaders/divergence.glsl"
    }
#line 63 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && !condition; any__(active_2)) {
#line 63 "tests/emit/shaders/divergence.glsl"
      if (Bool active_3 = active_2 && (n % 2 == 0); any__(active_3)) {
#line 63 "tests/emit/shaders/divergence.glsl"
        set__(active_3, c, c - 5);
#line 63 "tests/emit/shaders/divergence.glsl"
      }
#line 63 "tests/emit/shaders/divergence.glsl"
    }
    const Bool condition_2 = n % 3 == 0;
#line 64 "tests/emit/shaders/divergence.glsl"
    Int tmp_7{};
#line 64 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && condition_2; any__(active_2)) {
#line 64 "tests/emit/shaders/divergence.glsl"
      count(active_2, c);
#line 64 "tests/emit/shaders/divergence.glsl"
      set__(active_2, tmp_7, c * 2);
#line 64 "tests/emit/shaders/divergence.glsl"
    }
#line 64 "tests/emit/shaders/divergence.glsl"
    if (Bool active_2 = active && !condition_2; any__(active_2)) {
#line 64 "tests/emit/shaders/divergence.glsl"
      set__(active_2, tmp_7, select__(n % 3 == 1, make<Int>(at(grid, n % 9 - 1)), -c));
#line 64 "tests/emit/shaders/divergence.glsl"
    }
#line 64 "tests/emit/shaders/divergence.glsl"
    const Int tmp_8 = tmp_7;
#line 64 "tests/emit/shaders/divergence.glsl"
    c = c + tmp_8;
    vec4 v = vec4(p, 1.0f, 2.0f);
    const Int tmp_9 = n % 6 - 1;
#line 66 "tests/emit/shaders/divergence.glsl"
    Float element = at(v, tmp_9);
#line 66 "tests/emit/shaders/divergence.glsl"
    element = 7.0f;
#line 66 "tests/emit/shaders/divergence.glsl"
    put__(active, v, tmp_9, element);
#line 68 "tests/emit/shaders/divergence.glsl"
    array<Int, 2> more;
#line 68 "tests/emit/shaders/divergence.glsl"
    more[0] = 5;
#line 68 "tests/emit/shaders/divergence.glsl"
    more[1] = n;
    const Int tmp_10 = n & 1;
#line 69 "tests/emit/shaders/divergence.glsl"
    Int element_2 = at(more, tmp_10);
#line 69 "tests/emit/shaders/divergence.glsl"
    element_2 = element_2 + 1;
#line 69 "tests/emit/shaders/divergence.glsl"
    put__(active, more, tmp_10, element_2);
    Int i = 0;
    {
#line 71 "tests/emit/shaders/divergence.glsl"
      Bool loop = active;
#line 71 "tests/emit/shaders/divergence.glsl"
      for (;; set__(loop, i, i + 1)) {
#line 71 "tests/emit/shaders/divergence.glsl"
        loop = loop && (i < 9);
#line 71 "tests/emit/shaders/divergence.glsl"
        if (none__(loop)) break;
#line 71 "tests/emit/shaders/divergence.glsl"
        Bool active_2 = loop;
#line 71 "tests/emit/shaders/divergence.glsl"
        if (Bool active_3 = active_2 && (i == n % 11); any__(active_3)) {
#line 71 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2, loop);
#line 71 "tests/emit/shaders/divergence.glsl"
        }
#line 71 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 71 "tests/emit/shaders/divergence.glsl"
        if (Bool active_3 = active_2 && (i % 2 == 0); any__(active_3)) {
#line 71 "tests/emit/shaders/divergence.glsl"
          mask_out__(active_3, active_2);
#line 71 "tests/emit/shaders/divergence.glsl"
        }
#line 71 "tests/emit/shaders/divergence.glsl"
        if (none__(active_2)) continue;
#line 71 "tests/emit/shaders/divergence.glsl"
        const Int tmp_11 = i & 1;
#line 71 "tests/emit/shaders/divergence.glsl"
        Int element_3 = at(more, tmp_11);
#line 71 "tests/emit/shaders/divergence.glsl"
        set__(active_2, element_3, element_3 + i);
#line 71 "tests/emit/shaders/divergence.glsl"
        put__(active_2, more, tmp_11, element_3);
#line 71 "tests/emit/shaders/divergence.glsl"
      }
#line 71 "tests/emit/shaders/divergence.glsl"
    }
    if (Bool active_2 = active && (n % 8 < 6); any__(active_2)) {
#line 72 "tests/emit/shaders/divergence.glsl"
      if (Bool active_3 = active_2 && same__(at(first, n % 3), Item{vec2(4.0f, 5.0f), 6, false}); any__(active_3)) {
#line 72 "tests/emit/shaders/divergence.glsl"
        set__(active_3, c, c + 1000);
#line 72 "tests/emit/shaders/divergence.glsl"
      }
#line 72 "tests/emit/shaders/divergence.glsl"
      if (Bool active_3 = active_2 && !same__(bag.items[0], Item{vec2(1.0f, 2.0f), 3, true}); any__(active_3)) {
#line 72 "tests/emit/shaders/divergence.glsl"
        set__(active_3, c, c + 2000);
#line 72 "tests/emit/shaders/divergence.glsl"
      }
#line 72 "tests/emit/shaders/divergence.glsl"
    }
    Item some = at(bag.items, (n + 1) % 3);
    set__(active, color, vec4(make<Float>(a + b), w + make<Float>(r), dot(some.at_, bag.turn * v.xy()) + make<Float>(some.tag) + v.z * v.w, make<Float>(c + i * 10 + more[0] * 100 + more[1] + steps + select__(some.on, Int(5000), Int(0)))));
#line 74 "tests/emit/shaders/divergence.glsl"
  }
#line 569 "twin.cpp"

  void main(Bool active) {
    vec4 shadertoy_color = vec4(0.0f);
    mainImage(active, shadertoy_color, gl_FragCoord.xy());
    set__(active, shadertoy_out_color, shadertoy_color);
  }

};

}  // namespace
}  // namespace shadertwin::glsl::packet

SHADERTWIN_EXPORT_PACKETS(shadertoy_out_color)

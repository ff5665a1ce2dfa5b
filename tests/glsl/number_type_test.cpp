// A number type of the test's own is all that the built-in functions need: Counted is a float that counts
// what is done with it, and must come to float's bits in every function.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "tests/glsl/inputs.h"

namespace shadertwin::counting {

struct Counted {
  float value;

  static long operations;

  Counted() = default;
  Counted(float x) : value(x) {}
  explicit Counted(double x) : value(static_cast<float>(x)) {}
  explicit Counted(int x) : value(static_cast<float>(x)) {}
  explicit operator float() const { return value; }

  static Counted counted(float x) {
    ++operations;
    return {x};
  }
  friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return counted(a.value / b.value); }
  friend Counted operator-(Counted a) { return {-a.value}; }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
  friend bool operator<=(Counted a, Counted b) { return a.value <= b.value; }
  friend bool operator>=(Counted a, Counted b) { return a.value >= b.value; }
  friend bool operator==(Counted a, Counted b) { return a.value == b.value; }
  friend bool operator!=(Counted a, Counted b) { return a.value != b.value; }
  // GLM's vectors compute with these.
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  Counted& operator/=(Counted b) { return *this = *this / b; }

  friend Counted multiply_add(Counted a, Counted b, Counted c) {
    return counted(glsl::detail::multiply_add(a.value, b.value, c.value));
  }
  friend Counted root(Counted x) { return counted(glsl::detail::root(x.value)); }
  friend Counted round_down(Counted x) { return counted(glsl::detail::round_down(x.value)); }
  friend Counted round_up(Counted x) { return counted(glsl::detail::round_up(x.value)); }
  friend Counted round_to_zero(Counted x) { return counted(glsl::detail::round_to_zero(x.value)); }
  friend Counted round_to_even(Counted x) { return counted(glsl::detail::round_to_even(x.value)); }
  friend int to_int(Counted x) { return glsl::detail::to_int(x.value); }
};
long Counted::operations = 0;

static_assert(glsl::detail::Number<Counted>);

// --- GLSL with Counted for float --------------------------------------------

namespace detail = glsl::detail;
using Float = Counted;
using glsl::Bool, glsl::bvec2, glsl::bvec3, glsl::bvec4;
using glsl::Int, glsl::ivec2, glsl::ivec3, glsl::ivec4;
using glsl::Uint, glsl::uvec2, glsl::uvec3, glsl::uvec4;
using vec2 = glm::vec<2, Float>;
using vec3 = glm::vec<3, Float>;
using vec4 = glm::vec<4, Float>;
using mat2x2 = glm::mat<2, 2, Float>;
using mat2x3 = glm::mat<2, 3, Float>;
using mat2x4 = glm::mat<2, 4, Float>;
using mat3x2 = glm::mat<3, 2, Float>;
using mat3x3 = glm::mat<3, 3, Float>;
using mat3x4 = glm::mat<3, 4, Float>;
using mat4x2 = glm::mat<4, 2, Float>;
using mat4x3 = glm::mat<4, 3, Float>;
using mat4x4 = glm::mat<4, 4, Float>;
using mat2 = mat2x2;
using mat3 = mat3x3;
using mat4 = mat4x4;
#include "reference/glsl/builtins.def"

// --- Counted beside float ---------------------------------------------------

namespace {

template <class T>
struct CountedOf {
  using Type = T;
};
template <>
struct CountedOf<float> {
  using Type = Counted;
};
template <int N>
struct CountedOf<glm::vec<N, float>> {
  using Type = glm::vec<N, Counted>;
};
template <int C, int R>
struct CountedOf<glm::mat<C, R, float>> {
  using Type = glm::mat<C, R, Counted>;
};

template <class T>
typename CountedOf<T>::Type counted(const T& x) {
  typename CountedOf<T>::Type result;
  static_assert(sizeof result == sizeof x);
  std::memcpy(static_cast<void*>(&result), &x, sizeof x);
  return result;
}

// The bytes of a value, with one NaN for all.
template <class T>
std::vector<std::uint8_t> bytes(T x) {
  using Scalar = typename detail::Shape<T>::Scalar;
  std::vector<std::uint8_t> result(sizeof x);
  std::memcpy(result.data(), &x, sizeof x);
  if constexpr (std::is_same_v<Scalar, float> || std::is_same_v<Scalar, Counted>) {
    for (std::size_t i = 0; i < sizeof x; i += sizeof(float)) {
      float number;
      std::memcpy(&number, &result[i], sizeof number);
      if (number != number) std::memcpy(&result[i], &detail::nan, sizeof number);
    }
  }
  return result;
}

// Argument `index` of draw i: any bits, or numbers of a moderate size.
template <class T>
T draw(glsl::uint i, glsl::uint index) {
  using Kind = glsl::Domain::Kind;
  const glsl::Domain domain = i % 2 == 0 ? glsl::Domain{Kind::bits, 0, 0} : glsl::Domain{Kind::scale, -4, 4};
  float words[sizeof(T) / sizeof(float)];
  for (glsl::uint word = 0; word < std::size(words); ++word)
    words[word] = glsl::input_at(domain, i, word, index).x;
  T result;
  std::memcpy(static_cast<void*>(&result), words, sizeof result);
  return result;
}

class NumberType : public testing::Test {
 protected:
  // T...: the arguments of the overload.
  template <class... T, class OfFloat, class OfCounted>
  void same_bits(const char* name, const OfFloat& of_float, const OfCounted& of_counted) {
    seen_.insert(name);
    for (glsl::uint i = 0; i < 4000; ++i) {
      const auto arguments = [i]<glsl::uint... index>(std::integer_sequence<glsl::uint, index...>) {
        return std::tuple<T...>{draw<T>(i, index)...};
      }
      (std::make_integer_sequence<glsl::uint, sizeof...(T)>());
      const auto expected = std::apply([&](const T&... x) { return of_float(x...); }, arguments);
      const auto found = std::apply([&](const T&... x) { return of_counted(counted(x)...); }, arguments);
      ASSERT_EQ(bytes(found), bytes(expected)) << name << ", draw " << i;
    }
  }

  std::set<std::string> seen_;
};

#define BOTH(f) \
#f, [](const auto&... x) { return glsl::f(x...); }, [](const auto&... x) { return counting::f(x...); }
#define FOR_EVERY_SIZE(f)         \
  same_bits<float>(BOTH(f));      \
  same_bits<glsl::vec3>(BOTH(f)); \
  same_bits<glsl::vec4>(BOTH(f))
#define FOR_EVERY_SIZE_2(f)                   \
  same_bits<float, float>(BOTH(f));           \
  same_bits<glsl::vec2, glsl::vec2>(BOTH(f)); \
  same_bits<glsl::vec4, glsl::vec4>(BOTH(f))
#define FOR_EVERY_SIZE_3(f)                               \
  same_bits<float, float, float>(BOTH(f));                \
  same_bits<glsl::vec3, glsl::vec3, glsl::vec3>(BOTH(f)); \
  same_bits<glsl::vec4, glsl::vec4, glsl::vec4>(BOTH(f))

TEST_F(NumberType, OfTheTestsOwnHasFloatsBitsInEveryBuiltin) {
  FOR_EVERY_SIZE(radians);
  FOR_EVERY_SIZE(degrees);
  FOR_EVERY_SIZE(sin);
  FOR_EVERY_SIZE(cos);
  FOR_EVERY_SIZE(tan);
  FOR_EVERY_SIZE(asin);
  FOR_EVERY_SIZE(acos);
  FOR_EVERY_SIZE(atan);
  FOR_EVERY_SIZE(sinh);
  FOR_EVERY_SIZE(cosh);
  FOR_EVERY_SIZE(tanh);
  FOR_EVERY_SIZE(asinh);
  FOR_EVERY_SIZE(acosh);
  FOR_EVERY_SIZE(atanh);
  FOR_EVERY_SIZE(exp);
  FOR_EVERY_SIZE(log);
  FOR_EVERY_SIZE(exp2);
  FOR_EVERY_SIZE(log2);
  FOR_EVERY_SIZE(sqrt);
  FOR_EVERY_SIZE(inversesqrt);
  FOR_EVERY_SIZE(abs);
  FOR_EVERY_SIZE(sign);
  FOR_EVERY_SIZE(floor);
  FOR_EVERY_SIZE(trunc);
  FOR_EVERY_SIZE(round);
  FOR_EVERY_SIZE(roundEven);
  FOR_EVERY_SIZE(ceil);
  FOR_EVERY_SIZE(fract);
  FOR_EVERY_SIZE(isnan);
  FOR_EVERY_SIZE(isinf);
  FOR_EVERY_SIZE(floatBitsToInt);
  FOR_EVERY_SIZE(floatBitsToUint);
  FOR_EVERY_SIZE(length);
  FOR_EVERY_SIZE(normalize);
  FOR_EVERY_SIZE_2(atan);
  FOR_EVERY_SIZE_2(pow);
  FOR_EVERY_SIZE_2(mod);
  FOR_EVERY_SIZE_2(min);
  FOR_EVERY_SIZE_2(max);
  FOR_EVERY_SIZE_2(step);
  FOR_EVERY_SIZE_2(lessThan);
  FOR_EVERY_SIZE_2(lessThanEqual);
  FOR_EVERY_SIZE_2(greaterThan);
  FOR_EVERY_SIZE_2(greaterThanEqual);
  FOR_EVERY_SIZE_2(equal);
  FOR_EVERY_SIZE_2(notEqual);
  FOR_EVERY_SIZE_2(distance);
  FOR_EVERY_SIZE_2(dot);
  FOR_EVERY_SIZE_2(reflect);
  FOR_EVERY_SIZE_3(clamp);
  FOR_EVERY_SIZE_3(mix);
  FOR_EVERY_SIZE_3(mix_strict);
  FOR_EVERY_SIZE(atan_strict);
  FOR_EVERY_SIZE_2(atan_strict);
  FOR_EVERY_SIZE_3(smoothstep);
  FOR_EVERY_SIZE_3(faceforward);

  using glsl::vec2, glsl::vec3, glsl::vec4, glsl::mat2, glsl::mat3, glsl::mat4;
  same_bits<vec3, float>(BOTH(mod));
  same_bits<vec4, float>(BOTH(min));
  same_bits<vec2, float>(BOTH(max));
  same_bits<vec3, float, float>(BOTH(clamp));
  same_bits<vec3, vec3, float>(BOTH(mix));
  same_bits<float, vec4>(BOTH(step));
  same_bits<float, float, vec2>(BOTH(smoothstep));
  same_bits<float, float, float>(BOTH(refract));
  same_bits<vec3, vec3, float>(BOTH(refract));
  same_bits<vec3, vec3>(BOTH(cross));
#define BOTH_OF_MODF(part)                                         \
  "modf",                                                          \
      [](auto x) {                                                 \
        auto whole = x;                                            \
        [[maybe_unused]] auto fraction = glsl::modf(x, whole);     \
        return part;                                               \
      },                                                           \
      [](auto x) {                                                 \
        auto whole = x;                                            \
        [[maybe_unused]] auto fraction = counting::modf(x, whole); \
        return part;                                               \
      }
  same_bits<float>(BOTH_OF_MODF(fraction));
  same_bits<vec3>(BOTH_OF_MODF(whole));
  same_bits<vec3, vec3, vec3>(
      "mix", [](auto a, auto b, auto c) { return glsl::mix(a, b, glsl::lessThan(a, c)); },
      [](auto a, auto b, auto c) { return counting::mix(a, b, counting::lessThan(a, c)); });
  same_bits<int>(BOTH(intBitsToFloat));
  same_bits<glsl::uvec3>(BOTH(uintBitsToFloat));
  same_bits<vec2>(BOTH(packHalf2x16));
  same_bits<vec2>(BOTH(packSnorm2x16));
  same_bits<vec2>(BOTH(packUnorm2x16));
  same_bits<glsl::uint>(BOTH(unpackHalf2x16));
  same_bits<glsl::uint>(BOTH(unpackSnorm2x16));
  same_bits<glsl::uint>(BOTH(unpackUnorm2x16));
  same_bits<mat3, mat3>(BOTH(matrixCompMult));
  same_bits<vec2, vec4>(BOTH(outerProduct));
  same_bits<glsl::mat3x2>(BOTH(transpose));
  same_bits<mat2>(BOTH(determinant));
  same_bits<mat3>(BOTH(determinant));
  same_bits<mat4>(BOTH(determinant));
  same_bits<mat2>(BOTH(inverse));
  same_bits<mat3>(BOTH(inverse));
  same_bits<mat4>(BOTH(inverse));
  same_bits<mat3, vec3>(BOTH(operator*));
  same_bits<vec2, glsl::mat4x2>(BOTH(operator*));
  same_bits<glsl::mat3x4, glsl::mat2x3>(BOTH(operator*));
  same_bits<mat4, mat4>(BOTH(operator/));
  same_bits<vec4>(BOTH(operator-));

  // Nothing in the table is left out, but for functions of integers and truth values.
  for (const std::string_view name : {
#define SHADERTWIN_BUILTIN(op, f, ...) #f,
#define SHADERTWIN_HELPER(f, ...)
#include "reference/glsl/builtins.def"
       }) {
    if (name != "any" && name != "all") {
      EXPECT_TRUE(seen_.contains(std::string(name))) << name;
    }
  }
}

TEST_F(NumberType, SeesEveryStepOfAFunction) {
  Counted::operations = 0;
  static_cast<void>(dot(vec3(Counted(1.0F)), vec3(Counted(2.0F))));
  EXPECT_EQ(Counted::operations, 5);
  Counted::operations = 0;
  static_cast<void>(normalize(vec2(Counted(3.0F), Counted(4.0F))));
  EXPECT_EQ(Counted::operations, 3 + 2 + 2);  // the square, the root and its reciprocal, the product
}

}  // namespace
}  // namespace shadertwin::counting

#include "tests/glsl/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

#include "reference/glsl/denormals.h"

namespace shadertwin::glsl {

namespace {

const char* const argument_names[] = {"a", "b", "c", "d", "e", "f", "g", "h"};
constexpr vec4 Arguments::*members[] = {&Arguments::a, &Arguments::b, &Arguments::c, &Arguments::d,
                                        &Arguments::e, &Arguments::f, &Arguments::g, &Arguments::h};

// The few things that GLSL and C++ spell differently.
const char* const spellings = R"(#define Float float
#define XY(v) (v).xy
#define ZW(v) (v).zw
#define XYZ(v) (v).xyz
#define MAKE(type, v) type(v)
#define DIVIDE(x, y) ((x) / (y))
#define MODULO(x, y) ((x) % (y))
#define SHIFT_LEFT(x, y) ((x) << (y))
#define SHIFT_RIGHT(x, y) ((x) >> (y))
vec4 halves(uint a, uint b) { return vec4(a >> 16, a & 0xffffu, b >> 16, b & 0xffffu); }
)";

bool same(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<uint>(a) == std::bit_cast<uint>(b);
}

// "3 x D" for three equal domains.
std::string domains_text(const std::vector<Domain>& domains) {
  std::string text;
  for (std::size_t i = 0; i < domains.size();) {
    std::size_t same = 1;
    while (i + same < domains.size() && domains[i + same].text() == domains[i].text()) ++same;
    if (i > 0) text += "; ";
    if (same > 1) text += std::to_string(same) + " x ";
    text += domains[i].text();
    i += same;
  }
  return text;
}

std::string number(float x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.9g (%08x)", static_cast<double>(x), std::bit_cast<uint>(x));
  return buffer;
}

}  // namespace

double ulp_distance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) {
    return std::isnan(a) && std::isnan(b) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  const auto ordinal = [](float x) {
    const auto pattern = std::bit_cast<std::int32_t>(x);
    return pattern < 0 ? -static_cast<double>(pattern & 0x7fffffff) : static_cast<double>(pattern);
  };
  return std::abs(ordinal(a) - ordinal(b));
}

std::string shader_for(const BuiltinCase& test) {
  std::string text = input_functions() + spellings + "void mainImage(out vec4 r, in vec2 position) {\n" +
                     "  uvec2 pixel = uvec2(position);\n";
  for (std::size_t i = 0; i < test.domains.size(); ++i) {
    text += std::string("  vec4 ") + argument_names[i] + " = " +
            input_call(test.domains[i], static_cast<int>(i)) + ";\n";
  }
  return text + "  r = vec4(0.0);\n  " + test.glsl + "\n}\n";
}

Deviation measure(const BuiltinCase& test, const Draw& draw, int width, int height) {
  const Image drawn = draw(shader_for(test), width, height);
  const FlushDenormals flush;
  Deviation result;
  result.name = test.name;
  result.domain = domains_text(test.domains);

  Arguments arguments{};
  std::vector<double> distances;  // of the values that differ
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::size_t i = 0; i < test.domains.size(); ++i) {
        arguments.*members[i] =
            input_at(test.domains[i], static_cast<uint>(x), static_cast<uint>(y), static_cast<uint>(i));
      }
      const vec4 twin = test.cpp(arguments);
      const float* device = drawn.at(x, y);
      for (int i = 0; i < 4; ++i) {
        ++result.count;
        if (same(device[i], twin[i])) {
          ++result.equal;
          continue;
        }
        const double ulp = ulp_distance(device[i], twin[i]);
        distances.push_back(ulp);
        const double absolute = std::abs(static_cast<double>(device[i]) - static_cast<double>(twin[i]));
        if (std::isfinite(absolute)) result.max_absolute = std::max(result.max_absolute, absolute);
        const Difference difference{arguments, vec4(device[0], device[1], device[2], device[3]), twin, i,
                                    ulp};
        if (result.equal + 1 == result.count) result.first = difference;
        if (result.equal + 1 == result.count || ulp > result.max_ulp) result.worst = difference;
        result.max_ulp = std::max(result.max_ulp, ulp);
      }
    }
  }
  const auto beyond = static_cast<std::size_t>(result.count / 100);
  if (distances.size() > beyond) {
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(beyond),
                     distances.end(), std::greater<>());
    result.p99_ulp = distances[beyond];
  }
  return result;
}

std::string table_head() {
  return "| function | arguments | equal bits % | p99 ULP | max ULP | max difference "
         "|\n|---|---|---|---|---|---|\n";
}

std::string table_row(const Deviation& deviation) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, "| %s | %s | %.4f | %.4g | %.4g | %.3g |\n", deviation.name.c_str(),
                deviation.domain.c_str(),
                100.0 * static_cast<double>(deviation.equal) / static_cast<double>(deviation.count),
                deviation.p99_ulp, deviation.max_ulp, deviation.max_absolute);
  return buffer;
}

std::string text(const Difference& difference, std::size_t arguments) {
  std::string text;
  for (std::size_t i = 0; i < arguments; ++i) {
    text += std::string(argument_names[i]) + " = ";
    for (int k = 0; k < 4; ++k) text += (k == 0 ? "" : ", ") + number((difference.arguments.*members[i])[k]);
    text += "; ";
  }
  char ulp[32];
  std::snprintf(ulp, sizeof ulp, "%g", difference.ulp);
  return text + "component " + std::to_string(difference.component) + ": device " +
         number(difference.device[difference.component]) + ", twin " +
         number(difference.twin[difference.component]) + ", " + ulp + " ULP";
}

}  // namespace shadertwin::glsl

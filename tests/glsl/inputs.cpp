#include "tests/glsl/inputs.h"

#include <array>

namespace shadertwin::glsl {

namespace {

constexpr std::array<uint, 32> extremes{
    0x00000000U, 0x80000000U, 0x00000001U, 0x80000001U, 0x007fffffU, 0x807fffffU, 0x00800000U, 0x80800000U,
    0x7f7fffffU, 0xff7fffffU, 0x7f800000U, 0xff800000U, 0x7fc00000U, 0x3f800000U, 0xbf800000U, 0x3f7fffffU,
    0x3f800001U, 0x3f000000U, 0xbf000000U, 0x3effffffU, 0x40200000U, 0xc0200000U, 0x4b000000U, 0x4b800000U,
    0x4effffffU, 0x4f000000U, 0xcf000000U, 0x4f7fffffU, 0x4f800000U, 0x40490fdbU, 0xc2fc0000U, 0x43000000U};

// pcg4d of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9 (2020), no. 3.
uvec4 hash(uvec4 v) {
  v = v * 1664525U + 1013904223U;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v = v ^ (v >> 16U);
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

float from_pattern(uint h) {
  return uintBitsToFloat((h & 15U) == 0U ? extremes[(h >> 4) & 31U] : h);
}

float log_uniform(uint h, uint low, uint octaves, uint sign) {
  return uintBitsToFloat((h & 0x007fffffU) | ((low + (h >> 23) % octaves) << 23) | sign);
}

}  // namespace

std::string Domain::text() const {
  const std::string ends = "[2^" + std::to_string(low) + ", 2^" + std::to_string(high) + ")";
  switch (kind) {
    case Kind::bits:
      return "all bit patterns";
    case Kind::scale:
      return "+-" + ends;
    case Kind::positive:
      return ends;
    case Kind::range:
      return "+-2^" + std::to_string(high);
    case Kind::unit:
      return "[0, 1)";
  }
  return {};
}

vec4 input_at(const Domain& domain, uint x, uint y, uint index) {
  const uvec4 h = hash(uvec4(x, y, index, 7U));
  const uvec4 signs = hash(h) & 0x80000000U;
  const auto low = static_cast<uint>(domain.low + 127);
  const auto octaves = static_cast<uint>(domain.high - domain.low);
  vec4 result;
  for (int i = 0; i < 4; ++i) {
    switch (domain.kind) {
      case Domain::Kind::bits:
        result[i] = from_pattern(h[i]);
        break;
      case Domain::Kind::scale:
        result[i] = log_uniform(h[i], low, octaves, signs[i]);
        break;
      case Domain::Kind::positive:
        result[i] = log_uniform(h[i], low, octaves, 0U);
        break;
      case Domain::Kind::range:
        result[i] = std::ldexp(static_cast<float>(static_cast<int>(h[i] >> 8) - (1 << 23)), domain.high - 23);
        break;
      case Domain::Kind::unit:
        result[i] = static_cast<float>(h[i] >> 8) * 0x1p-24F;
        break;
    }
  }
  return result;
}

std::string input_functions() {
  std::string text = "const uint extremes[32] = uint[32](";
  for (std::size_t i = 0; i < extremes.size(); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(extremes[i]) + "u";
  return text + R"();
uvec4 hash(uvec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  v ^= v >> 16u;
  v.x += v.y * v.w; v.y += v.z * v.x; v.z += v.x * v.y; v.w += v.y * v.z;
  return v;
}
uvec4 draw(uvec2 pixel, uint index) { return hash(uvec4(pixel, index, 7u)); }
vec4 input_bits(uvec4 h) {
  for (int i = 0; i < 4; ++i) if ((h[i] & 15u) == 0u) h[i] = extremes[(h[i] >> 4) & 31u];
  return uintBitsToFloat(h);
}
vec4 input_scale(uvec4 h, uint low, uint octaves, uint sign) {
  return uintBitsToFloat((h & 0x007fffffu) | ((low + (h >> 23) % octaves) << 23) | (hash(h) & sign));
}
vec4 input_range(uvec4 h, float step) { return vec4(ivec4(h >> 8) - (1 << 23)) * step; }
vec4 input_unit(uvec4 h) { return vec4(h >> 8) * uintBitsToFloat(0x33800000u); }
)";
}

std::string input_call(const Domain& domain, int index) {
  const std::string draw = "draw(pixel, " + std::to_string(index) + "u)";
  const std::string octaves =
      ", " + std::to_string(domain.low + 127) + "u, " + std::to_string(domain.high - domain.low) + "u";
  switch (domain.kind) {
    case Domain::Kind::bits:
      return "input_bits(" + draw + ")";
    case Domain::Kind::scale:
      return "input_scale(" + draw + octaves + ", 0x80000000u)";
    case Domain::Kind::positive:
      return "input_scale(" + draw + octaves + ", 0u)";
    case Domain::Kind::range:
      return "input_range(" + draw + ", uintBitsToFloat(" + std::to_string((domain.high - 23 + 127) << 23) +
             "u))";
    case Domain::Kind::unit:
      return "input_unit(" + draw + ")";
  }
  return {};
}

}  // namespace shadertwin::glsl

#include "host/language/browser_names.h"

#include <array>
#include <initializer_list>

#include "host/language/tokens.h"

namespace shadertwin {

using Names = std::set<std::string_view>;

namespace {

Names split(std::string_view text) {
  Names names;
  for (const Token& token : tokenize(text)) names.insert(token.text);
  return names;
}

}  // namespace

const Names& later_words() {
  static const Names names = split(
      "packed shared buffer precise dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3 dmat3x4 "
      "dmat4x2 dmat4x3 dmat4x4 samplerCubeArray samplerCubeArrayShadow isamplerCubeArray usamplerCubeArray "
      "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t float16_t float32_t float64_t");
  return names;
}

const Names& other_builtins() {
  static const Names names = split(
      "bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB frexp ldexp uaddCarry "
      "usubBorrow umulExtended imulExtended packUnorm4x8 packSnorm4x8 unpackUnorm4x8 unpackSnorm4x8 "
      "textureGather textureGatherOffset textureGatherOffsets imageLoad imageStore imageSize imageAtomicAdd "
      "imageAtomicMin imageAtomicMax imageAtomicAnd imageAtomicOr imageAtomicXor imageAtomicExchange "
      "imageAtomicCompSwap atomicAdd atomicMin atomicMax atomicAnd atomicOr atomicXor atomicExchange "
      "atomicCompSwap atomicCounter atomicCounterIncrement atomicCounterDecrement barrier memoryBarrier "
      "memoryBarrierAtomicCounter memoryBarrierBuffer memoryBarrierImage memoryBarrierShared "
      "groupMemoryBarrier fma interpolateAtCentroid interpolateAtSample interpolateAtOffset texture1D "
      "texture1DProj texture1DLod texture1DProjLod texture2D texture2DProj texture2DLod texture2DProjLod "
      "texture3D texture3DProj texture3DLod texture3DProjLod textureCube textureCubeLod shadow1D shadow2D "
      "shadow1DProj shadow2DProj shadow1DLod shadow2DLod texture2DRect texture2DRectProj");
  return names;
}

const Names& builtins() {
  static const Names names = split(
      "radians degrees sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh pow exp log exp2 log2 "
      "sqrt inversesqrt abs sign floor trunc round roundEven ceil fract mod modf min max clamp mix step "
      "smoothstep isnan isinf floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat packSnorm2x16 "
      "unpackSnorm2x16 packUnorm2x16 unpackUnorm2x16 packHalf2x16 unpackHalf2x16 length distance dot cross "
      "normalize faceforward reflect refract matrixCompMult outerProduct transpose determinant inverse "
      "lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not textureSize texture "
      "textureProj textureLod textureOffset texelFetch texelFetchOffset textureProjOffset textureLodOffset "
      "textureProjLod textureProjLodOffset textureGrad textureGradOffset textureProjGrad "
      "textureProjGradOffset dFdx dFdy fwidth");
  return names;
}

const std::vector<Overload>& open_builtins() {
  static const std::vector<Overload> overloads = {
      {"mix", "float", {"float", "float", "float"}},
      {"mix", "float", {"float", "float", "bool"}},
      {"mix", "vec2", {"vec2", "vec2", "vec2"}},
      {"mix", "vec2", {"vec2", "vec2", "float"}},
      {"mix", "vec2", {"vec2", "vec2", "bvec2"}},
      {"mix", "vec3", {"vec3", "vec3", "vec3"}},
      {"mix", "vec3", {"vec3", "vec3", "float"}},
      {"mix", "vec3", {"vec3", "vec3", "bvec3"}},
      {"mix", "vec4", {"vec4", "vec4", "vec4"}},
      {"mix", "vec4", {"vec4", "vec4", "float"}},
      {"mix", "vec4", {"vec4", "vec4", "bvec4"}},
      {"texture", "vec4", {"sampler2D", "vec2"}},
      {"texture", "vec4", {"sampler2D", "vec2", "float"}},
      {"textureLod", "vec4", {"sampler2D", "vec2", "float"}},
      {"textureGrad", "vec4", {"sampler2D", "vec2", "vec2", "vec2"}},
      {"texelFetch", "vec4", {"sampler2D", "ivec2", "int"}},
      {"textureSize", "ivec2", {"sampler2D", "int"}},
      {"texture", "vec4", {"sampler3D", "vec3"}},
      {"texture", "vec4", {"sampler3D", "vec3", "float"}},
      {"textureLod", "vec4", {"sampler3D", "vec3", "float"}},
      {"textureGrad", "vec4", {"sampler3D", "vec3", "vec3", "vec3"}},
      {"texelFetch", "vec4", {"sampler3D", "ivec3", "int"}},
      {"textureSize", "ivec3", {"sampler3D", "int"}},
      {"texture", "vec4", {"samplerCube", "vec3"}},
      {"texture", "vec4", {"samplerCube", "vec3", "float"}},
      {"textureLod", "vec4", {"samplerCube", "vec3", "float"}},
      {"textureGrad", "vec4", {"samplerCube", "vec3", "vec3", "vec3"}},
      {"textureSize", "ivec2", {"samplerCube", "int"}}};
  return overloads;
}

namespace {

std::vector<Overload> overloads_of_es100() {
  std::vector<Overload> all = open_builtins();
  const auto add = [&all](std::initializer_list<std::string_view> names, std::string_view result,
                          std::vector<std::string_view> parameters) {
    for (const std::string_view name : names) all.push_back({name, result, parameters});
  };
  for (const std::string_view t : {"float", "vec2", "vec3", "vec4"}) {
    add({"radians", "degrees", "sin",  "cos",         "tan", "asin", "acos",  "atan", "exp",   "log",
         "exp2",    "log2",    "sqrt", "inversesqrt", "abs", "sign", "floor", "ceil", "fract", "normalize"},
        t, {t});
    add({"atan", "pow", "mod", "min", "max", "step", "reflect"}, t, {t, t});
    add({"clamp", "smoothstep", "faceforward"}, t, {t, t, t});
    add({"refract"}, t, {t, t, "float"});
    add({"length"}, "float", {t});
    add({"distance", "dot"}, "float", {t, t});
    if (t == "float") continue;
    add({"mod", "min", "max"}, t, {t, "float"});
    add({"clamp"}, t, {t, "float", "float"});
    add({"step"}, t, {"float", t});
    add({"smoothstep"}, t, {"float", "float", t});
  }
  add({"cross"}, "vec3", {"vec3", "vec3"});
  for (const std::string_view t : {"mat2", "mat3", "mat4"}) add({"matrixCompMult"}, t, {t, t});
  for (const auto& [floats, ints, bools] : {std::array<std::string_view, 3>{"vec2", "ivec2", "bvec2"},
                                            {"vec3", "ivec3", "bvec3"},
                                            {"vec4", "ivec4", "bvec4"}}) {
    for (const std::string_view t : {floats, ints})
      add({"lessThan", "lessThanEqual", "greaterThan", "greaterThanEqual", "equal", "notEqual"}, bools,
          {t, t});
    add({"equal", "notEqual"}, bools, {bools, bools});
    add({"any", "all"}, "bool", {bools});
    add({"not"}, bools, {bools});
  }
  return all;
}

}  // namespace

const std::vector<Overload>& open_builtins_of_es100() {
  static const std::vector<Overload> overloads = overloads_of_es100();
  return overloads;
}

}  // namespace shadertwin

// Names that browsers and native compilers of GLSL ES 3.00 do not treat alike.
#pragma once

#include <set>
#include <string_view>
#include <vector>

namespace shadertwin {

// Words of later versions of the language.
const std::set<std::string_view>& later_words();

// Built-in functions of GLSL ES 3.10 and 3.20, and of 1.00 with its extensions.
const std::set<std::string_view>& other_builtins();

// Built-in functions of GLSL ES 3.00.
const std::set<std::string_view>& builtins();

struct Overload {
  std::string_view name;
  std::string_view result;
  std::vector<std::string_view> parameters;  // types
};

// Built-in functions of GLSL ES 3.00 that browsers let a shader define again and overload.
const std::vector<Overload>& open_builtins();

// Those of GLSL ES 1.00, where a shader may do so with all, and of its functions for textures as 3.00 has
// them.
const std::vector<Overload>& open_builtins_of_es100();

}  // namespace shadertwin

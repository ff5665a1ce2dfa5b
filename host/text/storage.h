// How much memory the variables of a shader take, counted as browsers count it: every component is four
// bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/text/syntax_tree.h"

namespace shadertwin {

// Limits of Chromium's WebGL2, found by halving: float[16383] and vec3[5461] pass, float[16384] and
// vec3[5462] don't; and all variables together have at most 16 MiB.
constexpr std::int64_t most_components = 16383;
constexpr std::int64_t most_components_together = std::int64_t{4} << 20;

struct LargeVariable {
  std::string name;
  int token = -1;  // where it is declared
};

struct Storage {
  std::int64_t variables = 0;        // components of all variables that are used
  std::int64_t temporaries = 0;      // of the arrays and structures that calls and constructors give
  std::vector<LargeVariable> large;  // variables of more than most_components

  bool is_too_large_together() const { return variables > most_components_together; }
};

// Numbers beyond 2^40 stand for anything larger.
Storage measure_storage(const SyntaxTree& tree);

// The same. Throws Error(shader) for what is larger than browsers allow.
Storage measure_allowed_storage(const SyntaxTree& tree);

// Throws what measure_allowed_storage() throws, for a text that a driver is to compile as it is. One that
// can't be parsed is left to the driver.
void refuse_large_variables(const Project& project, const PassSource& source);

}  // namespace shadertwin

// How deep a shader's expressions, statements and structures may be nested. Compilers walk a shader by
// recursion, Mesa, glslang and the twin's among them, and end without a word where their stack ends; browsers
// refuse such a text long before.
#pragma once

#include <optional>
#include <vector>

#include "host/language/preprocessor.h"

namespace shadertwin {

// Chromium's "Expression too complex" begins at 254 operators within each other, a chain a + b + c ... among
// them. Text alone gives an upper bound only, to which every operator of an expression counts, so this is
// wide enough for whatever a browser takes.
constexpr int deepest_nesting = 4000;

// Chromium's limit: a structure may hold one that holds one that holds one. Sizes double with every level.
constexpr int deepest_structure = 4;

// The first place that is nested deeper than one of the two.
std::optional<Diagnostic> nested_too_deeply(const std::vector<PlainToken>& tokens);

}  // namespace shadertwin

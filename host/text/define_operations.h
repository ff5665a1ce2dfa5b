// Operations whose operands may be such that GLSL says nothing of the result: mod(x, 0.0), pow(0.0, 0.0),
// int() of what int can't hold, `%` of negatives ... reference/glsl/README.md has the table of what they give
// here and why. Drivers differ in them, so a driver's text calls a function of ours for each.
#pragma once

#include <string>

#include "host/text/rewritten_lines.h"
#include "host/text/syntax_tree.h"

namespace shadertwin {

// Rewrites those operations of the tree's text whose operands are not known to be harmless. Returns the
// functions that the new text calls.
std::string define_operations(const SyntaxTree& tree, RewrittenLines& edits);

}  // namespace shadertwin

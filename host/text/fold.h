// How glslang folds constant expressions.
//
// glslang computes constants in double. Every GLSL compiler of a driver computes them in float, operation by
// operation, so the last bits of `2.0 * PI / 3.0` would differ. The library's own folding functions are
// wrapped at link time (see CMakeLists.txt) to round operands and results to float. So is its parser's
// function for calls, since it folds f().length() to a number and forgets the call.
#pragma once

#include "host/text/syntax_tree.h"

namespace shadertwin {

// While it lives, constants of this thread are folded as `folding` says.
class ConstantFolding {
 public:
  explicit ConstantFolding(Folding folding);
  ~ConstantFolding();
  ConstantFolding(const ConstantFolding&) = delete;
  ConstantFolding& operator=(const ConstantFolding&) = delete;

 private:
  Folding previous_;
};

}  // namespace shadertwin

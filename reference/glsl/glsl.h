// GLSL ES 3.00 in C++: what a shader's emitted C++ includes. Types, operators and built-in functions have
// GLSL's names, and llvmpipe's bits where IEEE operations can give them.
//
// Compile with -ffp-contract=off -fwrapv and without -ffast-math. -march=native decides, as it does for
// llvmpipe, whether polynomials are fused.
#pragma once

#include "reference/glsl/builtins.h"  // IWYU pragma: export
#include "reference/glsl/check.h"     // IWYU pragma: export
#include "reference/glsl/probes.h"    // IWYU pragma: export
#include "reference/glsl/sampler.h"   // IWYU pragma: export
#include "reference/glsl/types.h"     // IWYU pragma: export

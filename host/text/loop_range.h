// Whether a loop's variable stays inside of an array by the loop's own header, so that an index needs no
// clamp: compilers unroll such loops, and a clamp would keep them from seeing that they can.
#pragma once

#include <vector>

#include "host/text/declarations.h"
#include "host/text/plain_tokens.h"
#include "host/text/zero_values.h"

namespace shadertwin {

// Whether token `use` names the variable of `for (int i = A; i < B; i++)` or the like, with constants, whose
// values all lie in [0, size), and which nothing in the loop writes.
bool stays_below(const std::vector<PlainToken>& tokens, const Declarations& declarations,
                 const ZeroValues& values, int use, int size);

}  // namespace shadertwin

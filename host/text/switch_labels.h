// Labels that glslang refuses though browsers take them.
#pragma once

#include <vector>

#include "host/text/plain_tokens.h"

namespace shadertwin {

// The tokens for the parser. Behind the last label of a switch glslang wants a statement that it keeps, and
// it keeps no empty ones and no declarations without a value: such a label's colon becomes `: break;`, one
// token still.
std::vector<PlainToken> with_kept_labels(std::vector<PlainToken> tokens);

}  // namespace shadertwin

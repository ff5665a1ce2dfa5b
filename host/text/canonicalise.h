// Browsers' WebGL2 takes some texts that native compilers of the same GLSL ES 3.00 refuse. This rewrites such
// a text so that both read it alike.
#pragma once

#include <string>
#include <string_view>

namespace shadertwin {

// `text`: preprocessed. No line is added or taken away. What changes:
// - identifiers that are words of the language only in later versions (`buffer`, `shared`, `precise` ...),
// and
//   functions named as built-ins of later versions (`fma`, `bitCount` ...) or of GLSL ES 1.00 (`texture2D`
//   ...), get the prefix "shadertwin_", and so does what has it, for the host's own names begin with it;
// - so do global variables and structures named as a built-in function, members called `length`, and
//   functions that overload those few built-ins which browsers leave open (`mix`, `texture` ...), or any in a
//   text that was written for GLSL ES 1.00;
// - a function's parameter without a name gets one;
// - `lowp`, `mediump`, `highp` and `precision` go: render() asks for highp, and declarations that differ in
//   precision only are taken for different functions elsewhere;
// - an empty statement behind the last label of a `switch` becomes `break`;
// - shadertoy.com's iChN.sampler, .size, .time and .loaded become iChannelN, iChannelResolution[N],
//   iChannelTime[N] and shadertwin_loaded_N (0 or 1).
std::string canonicalise(std::string_view text, bool es100 = false);

}  // namespace shadertwin

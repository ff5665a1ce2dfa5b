// Browsers' WebGL2 takes some texts that native compilers of the same GLSL ES 3.00 refuse, and gives zero
// where they give anything. This rewrites such a text so that both read it alike.
#pragma once

#include <string>
#include <string_view>

#include "host/project/project.h"

namespace shadertwin {

// `text`: preprocessed. No line is added or taken away. What changes:
// - identifiers that are words of the language only in later versions (`buffer`, `shared`, `packed`,
// `precise`,
//   `dmat3` ...), and functions named as built-ins of later versions (`fma`, `bitCount` ...) or of GLSL
//   ES 1.00
//   (`texture2D` ...), get the prefix "shadertwin_";
// - a function's parameter without a name gets one;
// - `lowp`, `mediump`, `highp` and `precision` go: render() asks for highp, and declarations that differ in
//   precision only are taken for different functions elsewhere;
// - a global variable named as a built-in function gets the prefix, and so do functions that overload those
// few
//   built-ins which browsers leave open (`mix`, `texture` ...);
// - an empty statement behind the last label of a `switch` becomes `break`;
// - a structure named as a built-in function gets the prefix;
// - a member called `length` of a structure gets the prefix;
// - shadertoy.com's iChN.sampler, .size, .time and .loaded become iChannelN, iChannelResolution[N],
// iChannelTime[N]
//   and shadertwin_loaded_N (0 or 1);
// - with Undefined::zero, an `out` parameter of a built-in type starts as zero.
std::string canonicalise(std::string_view text, Undefined undefined);

}  // namespace shadertwin

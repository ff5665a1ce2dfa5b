// main() as the host writes it, for every kind of pass.
#pragma once

#include <string>

#include "host/language/entry_points.h"
#include "host/project/project.h"

namespace shadertwin {

struct MainText {
  std::string prototype;  // of the user's function; a line
  std::string main;       // a line
};

// `asserts`: the shader uses shadertoy.com's st_assert. `inout`: the colour is an inout parameter.
MainText image_main(bool opaque, bool asserts, bool inout);
// Calls mainVR for two eyes side by side: 90 degrees high, 64 mm apart, looking along -z.
MainText vr_main(bool opaque);
// The face that the uniform int `shadertwin_face` says, 0 to 5 for +X -X +Y -Y +Z -Z; iResolution.xy is its
// size. The colour is rounded to half floats, which is what shadertoy.com keeps.
MainText cubemap_main();
// One sample a pixel of a target of sound_block_side by sound_block_side: left in r, right in g, not clamped.
// The first is number iSampleOffset, at iTimeOffset seconds.
MainText sound_main(bool of_time);

// shadertoy.com's st_assert(condition[, 0..3]), for shaders that use it.
std::string assert_text();

}  // namespace shadertwin

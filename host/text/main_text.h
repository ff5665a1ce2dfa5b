// main() as the host writes it, around each of the functions that a shader may have for it to call.
#pragma once

#include <string>
#include <string_view>

namespace shadertwin {

struct MainText {
  std::string prototype;  // of the user's function; a line
  std::string main;       // a line
};

struct MainOptions {
  bool opaque = false;          // alpha becomes 1
  bool asserts = false;         // the shader uses shadertoy.com's st_assert
  bool image_is_inout = false;  // EntryPoints has these two
  bool sound_of_time = false;
};

// Whether a host calls a function of that name, main() included.
bool is_entry_point(std::string_view name);

// The function that a host calls with its parameters, for people. `entry`: PassTraits::entry, or mainVR.
std::string signature(std::string_view entry);

// mainImage: a pixel of the picture.
// mainVR: two eyes side by side, 90 degrees high, 64 mm apart, looking along -z.
// mainCubemap: the face that the uniform int `shadertwin_face` says, 0 to 5 for +X -X +Y -Y +Z -Z;
// iResolution.xy is its size. The colour is rounded to half floats, which is what shadertoy.com keeps.
// mainSound: one sample a pixel of a target of sound_block_side by sound_block_side, left in r, right in g,
// not clamped. The first is number iSampleOffset, at iTimeOffset seconds.
MainText main_text(std::string_view entry, const MainOptions& options);

// shadertoy.com's st_assert(condition[, 0..3]), for shaders that use it.
std::string assert_text();

}  // namespace shadertwin

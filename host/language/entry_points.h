// Which functions that a host calls a shader defines.
#pragma once

#include <string_view>
#include <vector>

#include "host/language/tokens.h"

namespace shadertwin {

struct EntryPoints {
  bool main = false;                // void main()
  bool image = false;               // mainImage, or a macro that makes one
  bool cubemap = false;             // mainCubemap
  bool sound = false;               // mainSound
  bool sound_of_time = false;       // the old mainSound(float time), and it alone
  bool vr = false;                  // mainVR
  bool output = false;              // a global `out` variable of the user's
  bool image_is_macro = false;      // #define mainImage as something else
  bool image_names_itself = false;  // #define mainImage(a, b) mainImage(out vec4 a, in vec2 b)
  bool image_is_inout = false;      // mainImage(inout vec4
};

EntryPoints find_entry_points(const std::vector<Token>& tokens);

}  // namespace shadertwin

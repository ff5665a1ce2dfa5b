// Which functions that a host calls a shader defines.
#pragma once

#include <vector>

#include "host/language/tokens.h"

namespace shadertwin {

struct EntryPoints {
  bool main = false;            // void main()
  bool image = false;           // mainImage
  bool image_is_inout = false;  // mainImage(inout vec4
  bool cubemap = false;         // mainCubemap
  bool sound = false;           // mainSound
  bool sound_of_time = false;   // the old mainSound(float time), and it alone
  bool vr = false;              // mainVR
  int output_line = 0;          // of the first global `out` variable of the user's, from 1; 0: there is none
};

// `tokens`: of preprocessed text. A prototype counts as well: what it lacks is for the compiler to tell.
EntryPoints find_entry_points(const std::vector<Token>& tokens);

}  // namespace shadertwin

// Which functions that a host calls a shader defines.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/language/tokens.h"

namespace shadertwin {

struct EntryPoints {
  std::set<std::string, std::less<>> functions;  // all that have a name of the form mainSomething
  bool main = false;                             // void main()
  bool image_is_inout = false;                   // mainImage(inout vec4
  bool sound_of_time = false;                    // the old mainSound(float time), and it alone
  int output_line = 0;  // of the first global `out` variable of the user's, from 1; 0: there is none

  bool has(std::string_view name) const { return functions.contains(name); }
};

// The brace that opens the body of the function whose name is token `name`; tokens.size() if there is none.
std::size_t body_of_function(const std::vector<Token>& tokens, std::size_t name);

// `tokens`: of preprocessed text. A prototype counts as well: what it lacks is for the compiler to tell.
EntryPoints find_entry_points(const std::vector<Token>& tokens);

}  // namespace shadertwin

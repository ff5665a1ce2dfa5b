// Changes of a text by place, which are made all at once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shadertwin {

// `text` instead of the `length` bytes from `begin` on.
struct Edit {
  std::size_t begin = 0;
  std::size_t length = 0;
  std::string text;
};

// `text` with the edits, in any order; of those at one place the first stands first. What begins inside of a
// part that another one replaces is left out.
std::string edited(std::string_view text, std::vector<Edit> edits);

}  // namespace shadertwin

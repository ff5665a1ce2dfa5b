// A long text of many equal parts.
#pragma once

#include <string>
#include <string_view>

namespace shadertwin {

inline std::string repeated(std::string_view text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace shadertwin

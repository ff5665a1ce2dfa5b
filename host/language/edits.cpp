#include "host/language/edits.h"

#include <algorithm>

namespace shadertwin {

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t copied = 0;
  for (const Edit& edit : edits) {
    if (edit.begin < copied) continue;
    result.append(text.substr(copied, edit.begin - copied)).append(edit.text);
    copied = edit.begin + edit.length;
  }
  return result.append(text.substr(copied));
}

}  // namespace shadertwin

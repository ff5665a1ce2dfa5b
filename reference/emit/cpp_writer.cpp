#include "reference/emit/cpp_writer.h"

namespace shadertwin::emit {

std::optional<std::string> joined(const std::vector<CppLine>& lines) {
  if (lines.empty()) return "";
  if (!lines.front().is_statement) return {};
  std::string text = lines.front().text;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].type.empty() || lines[i].type != lines.front().type) return {};
    text += ", " + lines[i].declarator;
  }
  return text;
}

}  // namespace shadertwin::emit

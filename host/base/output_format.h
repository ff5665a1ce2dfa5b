// The kinds of files that are written. Each library has a table of its own, whose rows begin with what is
// here, and help and messages are made of them.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shadertwin {

struct OutputFormat {
  std::string_view extension;  // with its point, in lower case
  std::string_view about;      // what such a file holds, for people; may be empty
};

// The row for the file's extension, whatever its case; null if there is none.
template <typename Table>
const typename Table::value_type* find_format(const Table& table, const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.extension == extension; });
  return found == table.end() ? nullptr : &*found;
}

// The common part of every row.
template <typename Table>
std::vector<OutputFormat> output_formats(const Table& table) {
  return {table.begin(), table.end()};
}

// ".png, .jpg or .exr"; with what they hold, ".png (8 bits), .jpg or .exr (float32)".
inline std::string list_of(const std::vector<OutputFormat>& formats, bool about = false) {
  std::string text;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    text += i == 0 ? "" : i + 1 == formats.size() ? " or " : ", ";
    text += formats[i].extension;
    if (about && !formats[i].about.empty()) text += " (" + std::string(formats[i].about) + ')';
  }
  return text;
}

}  // namespace shadertwin

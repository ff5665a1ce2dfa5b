// The body of a pass as it grows: text, and for every line where it came from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

class Body {
 public:
  // Appends text whose first character stands on line `line` of `file`.
  void append(std::string_view text, int file, int line) {
    for (const char c : text) {
      if (at_line_start_) lines_.push_back({file, line});
      at_line_start_ = c == '\n';
      if (c == '\n') ++line;
      text_ += c;
    }
  }

  // Ends the line that has been begun. One that holds only space is taken back.
  void break_line() {
    if (at_line_start_) return;
    const std::size_t start = text_.rfind('\n') + 1;  // npos + 1 is 0
    if (text_.find_first_not_of(" \t", start) == std::string::npos) {
      text_.resize(start);
      lines_.pop_back();
    } else {
      text_ += '\n';
    }
    at_line_start_ = true;
  }

  std::size_t size() const { return text_.size(); }
  const std::string& text() const { return text_; }
  const std::vector<SourceLine>& lines() const { return lines_; }

 private:
  std::string text_;
  std::vector<SourceLine> lines_;
  bool at_line_start_ = true;
};

}  // namespace shadertwin

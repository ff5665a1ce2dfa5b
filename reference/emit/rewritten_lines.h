// A shader's tokens as lines again, with something put before or behind some of them.
#pragma once

#include <string>
#include <vector>

#include "host/project/project.h"
#include "reference/emit/tokens.h"

namespace shadertwin::emit {

struct RewrittenLines {
  explicit RewrittenLines(const std::vector<Token>& all)
      : before(all.size()), after(all.size()), tokens(all) {}

  // Line i holds the tokens of line i + 1.
  std::vector<std::string> lines(int count) const;

  std::vector<std::string> before;  // in front of the token of that number
  std::vector<std::string> after;
  const std::vector<Token>& tokens;
};

// Where head, body and tail of a pass begin and end.
class SectionLines {
 public:
  explicit SectionLines(const PassSource& source);

  int all() const { return head_ + body_ + tail_; }
  bool in_body(int line) const { return line > head_ && line <= head_ + body_; }  // from 1
  PassSource split(const std::vector<std::string>& lines) const;

 private:
  const PassSource& source_;
  int head_;
  int body_;
  int tail_;
};

}  // namespace shadertwin::emit

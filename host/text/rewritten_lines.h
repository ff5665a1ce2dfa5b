// A shader's tokens as lines again, with something put before, behind or instead of some of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/project/project.h"
#include "host/text/plain_tokens.h"

namespace shadertwin {

struct RewrittenLines {
  explicit RewrittenLines(const std::vector<PlainToken>& all)
      : before(all.size()), after(all.size()), tokens(all) {}

  // Line i holds the tokens of line i + 1.
  std::vector<std::string> lines(int count) const;

  std::vector<std::string> before;  // in front of the token of that number
  std::vector<std::string> after;
  std::map<int, std::string> instead;
  const std::vector<PlainToken>& tokens;
};

// Where head, body and tail of a pass begin and end in its rendered text.
class SectionLines {
 public:
  explicit SectionLines(const PassSource& source);

  int all() const { return front_ + head_ + body_ + tail_; }
  bool in_body(int line) const {  // from 1
    return line > front_ + head_ && line <= front_ + head_ + body_;
  }
  // Of what stands in front of the head, which is render()'s, the helpers are kept.
  PassSource split(const std::vector<std::string>& lines) const;

 private:
  const PassSource& source_;
  int front_;
  int head_;
  int body_;
  int tail_;
};

}  // namespace shadertwin

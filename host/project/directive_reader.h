// What the parts of a directive's parser share: a place in the tokens, and errors that name file and line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/language/tokens.h"
#include "host/project/project.h"

namespace shadertwin {

class DirectiveReader {
 public:
  DirectiveReader(const std::vector<Token>& tokens, const std::string& file) : tokens_(tokens), file_(file) {}

  std::size_t place() const { return at_; }
  // Starts on the token with index `at`.
  void start(std::size_t at) { at_ = at; }
  bool done() const { return at_ >= tokens_.size(); }
  const Token& peek(std::size_t ahead = 0) const {
    static const Token nothing;
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : nothing;
  }
  const Token& last() const { return tokens_[at_ - 1]; }
  const Token& take() { return tokens_[at_++]; }
  bool take_if(std::string_view text) {
    if (!peek().is(text)) return false;
    ++at_;
    return true;
  }
  void expect(std::string_view text) {
    if (!take_if(text)) fail("expected '" + std::string(text) + "'" + found());
  }
  // ", not 'x'", for messages.
  std::string found() const {
    if (done()) return ", not the end of the file";
    return ", not '" + std::string(peek().text) + "'";
  }
  // An error is reported where the directive stands, or at what was read last.
  [[noreturn]] void fail(const std::string& message) const {
    const int line = at_ == 0 ? 1 : tokens_[at_ - 1].line;
    throw Error(ExitStatus::shader, file_ + ":" + std::to_string(line) + ": error: " + message);
  }
  // A quoted text, its escapes resolved.
  std::string string(const std::string& what);

 private:
  const std::vector<Token>& tokens_;
  const std::string& file_;
  std::size_t at_ = 0;
};

// The rest of an #iUniform, after its first word.
CustomUniform read_uniform(DirectiveReader& reader);

}  // namespace shadertwin

// What the parts of the preprocessor hand to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include "host/language/preprocessor.h"

namespace shadertwin {

struct PreprocessingToken {
  enum class Kind {
    identifier,
    integer,
    floating,
    invalid_number,  // 08, 1..2, 1f
    punctuation,
    invalid_character,  // also #, which nothing but a directive has
    line_end,
    end,  // of the text or of a macro's argument
  };
  Kind kind = Kind::end;
  bool space_before = false;
  bool never_expands = false;  // a macro's name that was met in its own expansion
  bool starts_line = false;    // nothing but space and comments stands before it
  int line = 1;                // physical
  int numbered_line = 1;       // as #line has it
  int file = 0;                // as #line has it
  std::string_view text;

  bool is(Kind k) const { return kind == k; }
  bool is(char c) const { return kind == Kind::punctuation && text.size() == 1 && text[0] == c; }
  bool ends_directive() const { return kind == Kind::line_end || kind == Kind::end; }
};

class TokenSource {
 public:
  TokenSource() = default;
  TokenSource(const TokenSource&) = delete;
  TokenSource& operator=(const TokenSource&) = delete;
  virtual ~TokenSource() = default;
  // The next token; `end` again and again at the end.
  virtual PreprocessingToken next() = 0;
};

// Where errors go, and what is left of the work that a text may cause.
class PreprocessingState {
 public:
  static constexpr std::size_t error_limit = 100;
  static constexpr std::int64_t step_limit = 4'000'000;

  void error(int line, std::string message);
  // Counts tokens that macros make. False from where there are too many on: the text is to end there.
  bool spend(std::int64_t steps, int line);
  bool exhausted() const { return steps_left_ < 0; }
  void exhaust(int line, const std::string& message);

  // Keeps a text that tokens refer to.
  std::string_view intern(std::string text) { return texts_.emplace_back(std::move(text)); }

  PlainText result;

 private:
  std::int64_t steps_left_ = step_limit;
  std::deque<std::string> texts_;
};

// How a token is named in a message, shortened; never more than printable characters.
std::string quoted(const PreprocessingToken& token);
std::string quoted(std::string_view text);

}  // namespace shadertwin

#include "host/language/source_reader.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "host/language/characters.h"

namespace shadertwin {

namespace {

using Kind = PreprocessingToken::Kind;

constexpr int largest_number = std::numeric_limits<int>::max();
constexpr TokenizeOptions glsl = {.strings = false, .line_ends = true};

bool is_hexadecimal(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

// How many characters `of` accepts from `at` on.
template <typename Predicate>
std::size_t run_of(std::string_view text, std::size_t at, Predicate of) {
  std::size_t end = at;
  while (end < text.size() && of(text[end])) ++end;
  return end - at;
}

// 1, 017, 0xFF, each with up to two u: ANGLE takes the second for part of the number, and its parser refuses
// it later.
bool is_integer(std::string_view number) {
  for (int i = 0; i < 2 && (number.ends_with('u') || number.ends_with('U')); ++i) number.remove_suffix(1);
  if (number.empty()) return false;
  if (number.starts_with("0x") || number.starts_with("0X"))
    return number.size() > 2 && run_of(number, 2, is_hexadecimal) == number.size() - 2;
  if (number[0] == '0')
    return run_of(number, 0, [](char c) { return c >= '0' && c <= '7'; }) == number.size();
  return run_of(number, 0, is_digit) == number.size();
}

// 1., .5, 1.5e-3f, 1e3
bool is_floating(std::string_view number) {
  std::size_t at = run_of(number, 0, is_digit);
  const bool point = at < number.size() && number[at] == '.';
  if (point) at += 1 + run_of(number, at + 1, is_digit);
  if (at == (point ? 1U : 0U)) return false;
  const bool exponent = at < number.size() && (number[at] == 'e' || number[at] == 'E');
  if (exponent) {
    ++at;
    if (at < number.size() && (number[at] == '+' || number[at] == '-')) ++at;
    const std::size_t digits = run_of(number, at, is_digit);
    if (digits == 0) return false;
    at += digits;
  }
  if (!point && !exponent) return false;
  if (at < number.size() && (number[at] == 'f' || number[at] == 'F')) ++at;
  return at == number.size();
}

Kind kind_of(const Token& token) {
  switch (token.kind) {
    case Token::Kind::identifier:
      return Kind::identifier;
    case Token::Kind::number:
      return number_kind(token.text);
    case Token::Kind::line_end:
      return Kind::line_end;
    default:
      constexpr std::string_view punctuation = "[]<>(){}.+-/*%^|&~=!:;,?";
      return punctuation.find(token.text[0]) == std::string_view::npos ? Kind::invalid_character
                                                                       : Kind::punctuation;
  }
}

}  // namespace

Kind number_kind(std::string_view number) {
  if (is_integer(number)) return Kind::integer;
  return is_floating(number) ? Kind::floating : Kind::invalid_number;
}

std::vector<PreprocessingToken> tokens_of_line(std::string_view text) {
  std::vector<PreprocessingToken> result;
  for (const Token& token : tokenize(text, {.strings = false})) {
    PreprocessingToken made;
    made.kind = kind_of(token);
    made.text = token.text;
    made.space_before = token.space_before && !result.empty();
    result.push_back(made);
  }
  return result;
}

SourceReader::SourceReader(std::string_view text, PreprocessingState& state) : state_(state) {
  unfold(text);
  tokens_ = tokenize(text_, glsl);
  last_line_ =
      1 + static_cast<int>(std::count(text_.begin(), text_.end(), '\n') + std::ssize(continuations_));
}

// Takes out continuations, makes every line end \n, and every character beyond ASCII a question mark for each
// of its units in UTF-16, as browsers do.
void SourceReader::unfold(std::string_view text) {
  text_.reserve(text.size());
  const auto line_end = [&](std::size_t i) -> std::size_t {
    if (i >= text.size()) return 0;
    if (text[i] == '\n') return 1;
    if (text[i] != '\r') return 0;
    return i + 1 < text.size() && text[i + 1] == '\n' ? 2 : 1;
  };
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (const std::size_t length = line_end(i)) {
      text_ += '\n';
      i += length;
    } else if (byte == '\\' && line_end(i + 1) != 0) {
      i += 1 + line_end(i + 1);
      continuations_.push_back(text_.size());
      // ANGLE takes this for the end of its input.
      if (i < text.size() && text[i] == '\\') return;
    } else {
      if (byte < 0x80)
        text_ += text[i];
      else if (byte >= 0xC0)  // not one that continues a character
        text_ += byte >= 0xF0 ? "??" : "?";
      ++i;
    }
  }
}

PreprocessingToken SourceReader::next() {
  if (ended_ || state_.exhausted() || at_ >= tokens_.size()) return end();
  const Token& token = tokens_[at_++];
  // ANGLE reads on behind a word before it takes the line's number: __LINE__ that touches a continuation has
  // the next.
  const std::size_t place = token.is("__LINE__") ? token.end() : token.begin;
  while (hidden_ < continuations_.size() && continuations_[hidden_] <= place) ++hidden_;
  PreprocessingToken made;
  made.line = line_ = token.line + static_cast<int>(hidden_);
  if (token.kind == Token::Kind::open_comment) {
    state_.error(made.line, "the text ends in a comment that begins here");
    ended_ = true;
    return end();
  }
  const std::int64_t numbered = line_ + offset_;
  if (numbered > largest_number || (numbered == largest_number && token.kind == Token::Kind::line_end)) {
    tell_overflow();
    return end();
  }
  made.kind = kind_of(token);
  made.numbered_line = static_cast<int>(numbered);
  made.file = file_;
  made.space_before = token.space_before;
  made.starts_line = starts_line_;
  made.text = token.text;
  starts_line_ = made.kind == Kind::line_end;
  if (made.text.size() > longest_token) {
    state_.error(made.line,
                 quoted(made.text) + " is longer than " + std::to_string(longest_token) + " characters");
    made.text = made.text.substr(0, longest_token);
  }
  return made;
}

PreprocessingToken SourceReader::end() {
  if (!ended_ && !state_.exhausted()) {
    line_ = last_line_;
    if (line_ + offset_ >= largest_number) tell_overflow();
  }
  ended_ = true;
  PreprocessingToken made;
  made.line = line_;
  return made;
}

void SourceReader::tell_overflow() {
  state_.error(line_, "lines are numbered beyond " + std::to_string(largest_number));
  ended_ = true;
}

void SourceReader::set_line(int line) {
  offset_ = static_cast<std::int64_t>(line) - (line_ + 1);
}

}  // namespace shadertwin

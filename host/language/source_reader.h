// A shader's text as preprocessing tokens: comments and continued lines gone, line numbers kept, no directive
// obeyed but #line's count.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "host/language/preprocessing_token.h"
#include "host/language/tokens.h"

namespace shadertwin {

class SourceReader : public TokenSource {
 public:
  // The longest token that browsers take.
  static constexpr std::size_t longest_token = 1024;

  SourceReader(std::string_view text, PreprocessingState& state);

  PreprocessingToken next() override;

  // From the next line on, lines count from `line`.
  void set_line(int line);
  void set_file(int file) { file_ = file; }

 private:
  void unfold(std::string_view text);
  PreprocessingToken end();
  void tell_overflow();

  PreprocessingState& state_;
  std::string text_;                        // one \n a line end, continuations taken out
  std::vector<std::size_t> continuations_;  // where in text_ each was
  std::vector<Token> tokens_;
  std::size_t at_ = 0;       // in tokens_
  std::size_t hidden_ = 0;   // continuations passed
  int line_ = 1;             // physical, of the last token
  int last_line_ = 1;        // physical, where the text ends
  std::int64_t offset_ = 0;  // from the physical line to the numbered one
  int file_ = 0;
  bool starts_line_ = true;
  bool ended_ = false;
};

// The kind of a token by its text, for text that no reader holds.
PreprocessingToken::Kind number_kind(std::string_view number);

// `text` as tokens of one line. It must outlive them.
std::vector<PreprocessingToken> tokens_of_line(std::string_view text);

}  // namespace shadertwin

#include "host/language/preprocessing_token.h"

namespace shadertwin {

void PreprocessingState::error(int line, std::string message) {
  if (result.errors.size() < error_limit) result.errors.push_back({line, std::move(message)});
}

bool PreprocessingState::spend(std::int64_t steps, int line) {
  if (exhausted()) return false;
  steps_left_ -= steps;
  if (!exhausted()) return true;
  exhaust(line, "macros make more than " + std::to_string(step_limit) + " tokens before the text is done");
  return false;
}

void PreprocessingState::exhaust(int line, const std::string& message) {
  steps_left_ = -1;
  error(line, message);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

std::string quoted(const PreprocessingToken& token) {
  return token.ends_directive() ? "the end of the line" : quoted(token.text);
}

}  // namespace shadertwin

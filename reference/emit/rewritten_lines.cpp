#include "reference/emit/rewritten_lines.h"

#include <algorithm>

namespace shadertwin::emit {
namespace {

int line_count(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) +
         (!text.empty() && text.back() != '\n' ? 1 : 0);
}

std::string joined(const std::vector<std::string>& lines, int first, int count) {
  std::string text;
  for (int i = first; i < first + count; ++i) text += lines[static_cast<std::size_t>(i)] + '\n';
  return text;
}

}  // namespace

std::vector<std::string> RewrittenLines::lines(int count) const {
  std::vector<std::string> lines(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::string& line = lines[static_cast<std::size_t>(std::clamp(tokens[i].line, 1, count) - 1)];
    if (!line.empty()) line += ' ';
    line += before[i] + tokens[i].text + after[i];
  }
  return lines;
}

SectionLines::SectionLines(const PassSource& source)
    : source_(source),
      head_(line_count(source.head)),
      body_(line_count(source.body)),
      tail_(line_count(source.tail)) {}

PassSource SectionLines::split(const std::vector<std::string>& lines) const {
  return {joined(lines, 0, head_), joined(lines, head_, body_), joined(lines, head_ + body_, tail_),
          source_.lines};
}

}  // namespace shadertwin::emit

#include "host/text/rewritten_lines.h"

#include <algorithm>

#include "host/text/render.h"

namespace shadertwin {
namespace {

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
    const auto other = instead.find(static_cast<int>(i));
    line += before[i] + (other == instead.end() ? tokens[i].text : other->second) + after[i];
  }
  return lines;
}

SectionLines::SectionLines(const PassSource& source)
    : source_(source),
      front_(first_body_line(source) - 1 - line_count(source.head)),
      head_(line_count(source.head)),
      body_(line_count(source.body)),
      tail_(line_count(source.tail)) {}

PassSource SectionLines::split(const std::vector<std::string>& lines) const {
  PassSource result = source_;
  result.helpers = lines.at(helpers_line - 1);
  result.head = joined(lines, front_, head_);
  result.body = joined(lines, front_ + head_, body_);
  result.tail = joined(lines, front_ + head_ + body_, tail_);
  return result;
}

}  // namespace shadertwin

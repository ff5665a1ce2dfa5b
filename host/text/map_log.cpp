#include "host/text/map_log.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

#include "host/text/render.h"

namespace shadertwin {

namespace {

struct Message {
  int line = 0;
  std::string text;  // with "error: " or "warning: " in front
};

std::string with_severity(const std::string& severity, const std::string& text) {
  return (severity.empty() ? "error" : severity) + ": " + text;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::optional<Message> parse(const std::string& line) {
  // 0:12(5): error: text, and "preprocessor error"
  static const std::regex mesa(
      R"(^\s*\d+:(\d+)\(\d+\):\s*(?:preprocessor\s+)?(error|warning|note)?:?\s*(.*)$)");
  // 0(12) : error C0000: text
  static const std::regex nvidia(
      R"(^\s*\d+\((\d+)\)\s*:\s*(?:fatal )?(error|warning)\s*(?:[A-Z]\d+)?\s*:\s*(.*)$)");
  // ERROR: 0:12: text
  static const std::regex angle(R"(^\s*(ERROR|WARNING):\s*\d+:(\d+):\s*(.*)$)");
  std::smatch match;
  if (std::regex_match(line, match, mesa) || std::regex_match(line, match, nvidia))
    return Message{std::atoi(match[1].str().c_str()), with_severity(match[2], match[3])};
  if (std::regex_match(line, match, angle))
    return Message{std::atoi(match[2].str().c_str()), with_severity(lower(match[1]), match[3])};
  return std::nullopt;
}

// Mesa lists every overload of a built-in function, some sixty of texture(), each as an error of its own.
bool is_candidate(const std::string& line) {
  static const std::regex mesa(R"(^\s*\d+:\d+\(\d+\): error:    \w.*\)$)");
  return std::regex_match(line, mesa);
}

// glslang's way of saying that it read no further.
bool is_end(const std::string& line) {
  return line.ends_with("'' : compilation terminated ");
}

}  // namespace

std::size_t begin_of_line(std::string_view text, std::size_t line) {
  std::size_t begin = 0;
  for (; line > 0 && begin < text.size(); --line)
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  return begin;
}

std::string place_in_body(const Project& project, const PassSource& source, int line) {
  if (line < 0 || source.lines.empty()) return "";
  const auto index = std::min(static_cast<std::size_t>(line), source.lines.size() - 1);
  const SourceLine& place = source.lines[index];
  if (place.file >= 0)
    return project.files[static_cast<std::size_t>(place.file)] + ":" + std::to_string(place.line);
  if (index >= project.defines.size()) return "";
  const auto& [name, value] = project.defines[index];
  return "-D " + name + (value.empty() ? "" : "=" + value);
}

std::string map_log(const Project& project, const PassSource& source, const std::string& log) {
  const int first = first_body_line(source);
  static const std::string candidates = "; candidates are:";
  std::istringstream lines(log);
  std::string mapped;
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == '\0')) line.pop_back();
    if (line.empty() || is_candidate(line) || is_end(line)) continue;
    if (line.ends_with(candidates)) line.resize(line.size() - candidates.size());
    if (!mapped.empty()) mapped += '\n';
    const std::optional<Message> message = parse(line);
    const std::string place = message ? place_in_body(project, source, message->line - first) : "";
    mapped += place.empty() ? line : place + ": " + message->text;
  }
  return mapped;
}

}  // namespace shadertwin

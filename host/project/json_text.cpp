#include "host/project/json_text.h"

#include <algorithm>

#include "host/base/error.h"

namespace shadertwin {

namespace {

constexpr int max_depth = 64;

// Writing a document recurses, so its depth must be limited where it comes in. The parser's own callback
// could do it, but makes it scan every array once for each of its members.
void check_depth(const std::string& text, const std::string& name) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > max_depth)
      throw Error(ExitStatus::file, name + ": error: over " + std::to_string(max_depth) + " levels of JSON");
  }
}

[[noreturn]] void fail(const std::string& name, const std::string& what, const char* type) {
  throw Error(ExitStatus::file, name + ": error: " + what + " is not " + type);
}

}  // namespace

Json parse_json(const std::string& text, const std::string& name) {
  check_depth(text, name);
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& problem) {
    const std::size_t place = std::min<std::size_t>(problem.byte == 0 ? 0 : problem.byte - 1, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    const std::size_t column = place - (place == 0 ? 0 : text.rfind('\n', place - 1) + 1) + 1;
    const bool cut_off = place >= text.size();
    throw Error(ExitStatus::file, name + ":" + std::to_string(line) + ": error: this is not JSON: " +
                                      (cut_off ? "the text ends too early"
                                               : "unexpected text in column " + std::to_string(column)));
  } catch (const Json::exception& problem) {
    throw Error(ExitStatus::file, name + ": error: this is not JSON: " + problem.what());
  }
}

const Json& need_object(const Json& value, const std::string& name, const std::string& what) {
  if (!value.is_object()) fail(name, what, "an object");
  return value;
}

const Json& need_array(const Json& value, const std::string& name, const std::string& what) {
  if (!value.is_array()) fail(name, what, "an array");
  return value;
}

const std::string& need_string(const Json& value, const std::string& name, const std::string& what) {
  if (!value.is_string()) fail(name, what, "a string");
  return value.get_ref<const std::string&>();
}

}  // namespace shadertwin

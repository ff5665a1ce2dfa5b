#include "tests/emit/emitted.h"

#include <algorithm>

namespace shadertwin {
namespace {

// Without #line directives and indentation, so that texts can be compared.
std::string plain(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t start = std::min(text.find_first_not_of(' ', at), end);
    const std::string line = text.substr(start, end - start);
    if (line.rfind("#line", 0) != 0 && !line.empty()) result += line + '\n';
    at = end + 1;
  }
  return result;
}

}  // namespace

std::string emitted(const std::string& functions, const CppOptions& options) {
  Project project;
  project.files = {"shader.glsl"};
  Pass pass;
  pass.source.own_output = true;
  pass.source.head = "out vec4 o;\n";
  pass.source.body = functions + "\n";
  pass.source.tail = "void main() { o = vec4(1.0); }\n";
  const int lines = static_cast<int>(std::count(pass.source.body.begin(), pass.source.body.end(), '\n'));
  for (int i = 1; i <= lines; ++i) pass.source.lines.push_back({0, i});
  project.passes.push_back(pass);
  return emit_cpp(project, pass, options);
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (plain(text).find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "not found:\n" << part << "in:\n" << plain(text);
}

}  // namespace shadertwin

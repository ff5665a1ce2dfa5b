#include "host/project/vertex_text.h"

#include "host/project/paths.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

void warn(Project& project, const PlacedDirective& at, const std::string& message) {
  project.warnings.push_back(display_name(at.file) + ":" + std::to_string(at.directive.line) +
                             ": warning: " + message);
}

[[noreturn]] void fail(const PlacedDirective& at, const std::string& message) {
  fail_at(ExitStatus::shader, at.file, at.directive.line,
          "#iVertex \"" + at.directive.text + "\": " + message);
}

}  // namespace

std::optional<PlacedDirective> find_vertex(Project& project, const std::vector<PlacedDirective>& directives) {
  std::optional<PlacedDirective> last;
  for (const PlacedDirective& at : directives) {
    if (at.directive.kind != Directive::Kind::vertex) continue;
    if (last.has_value()) warn(project, *last, "this #iVertex does not count: there is a later one");
    last = at;
  }
  if (!last.has_value() || last->directive.text == "default") return std::nullopt;
  const std::string& path = last->directive.text;
  if (path == "self" || path == "file://self") fail(*last, "a pass can't be its own vertex shader");
  if (is_remote(path)) fail(*last, "nothing is fetched");
  if (plain_name(fs::path(path).extension().string()) != ".glsl") fail(*last, "the file must end in .glsl");
  return last;
}

PassSource load_vertex(Project& project, TextLoader& texts, const PlacedDirective& at, const fs::path& root,
                       const LoadOptions& options) {
  const std::optional<fs::path> file = find_file(candidates(at.directive.text, at.file, root));
  if (!file)
    fail_at(ExitStatus::file, at.file, at.directive.line,
            "can't find \"" + at.directive.text + "\", the vertex shader");
  Body body;
  body.append(to_text(options.settings.defines), -1, 0);
  std::vector<PlacedDirective> directives;
  texts.append(*file, body, directives);
  if (!directives.empty())
    warn(project, directives.front(), "in a vertex shader no directive counts but #include");
  PassSource source;
  source.body = body.text();
  source.lines = body.lines();
  return source;
}

}  // namespace shadertwin

#include "host/project/text_loader.h"

#include <algorithm>

#include "host/language/tokens.h"
#include "host/project/paths.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

// A chain of files that include the next one twice doubles at every step.
constexpr std::size_t max_body = std::size_t{64} << 20;
constexpr int max_includes = 10000;

std::string names(const std::vector<fs::path>& places) {
  std::string list;
  for (const fs::path& place : places) list += (list.empty() ? "" : ", ") + display_name(place);
  return list;
}

}  // namespace

void fail_at(ExitStatus status, const fs::path& file, int line, const std::string& message) {
  throw Error(status, display_name(file) + ":" + std::to_string(line) + ": error: " + message);
}

void TextLoader::skip(const fs::path& file) {
  skipped_.insert(identity(file));
}

int TextLoader::file_index(const std::string& name) {
  const auto known = std::find(project_.files.begin(), project_.files.end(), name);
  if (known != project_.files.end()) return static_cast<int>(known - project_.files.begin());
  project_.files.push_back(name);
  return static_cast<int>(project_.files.size()) - 1;
}

void TextLoader::append(const fs::path& file, Body& body, std::vector<PlacedDirective>& found) {
  open_.push_back(identity(file));
  append_text(read_text(file), display_name(file), file, body, found);
  open_.pop_back();
}

void TextLoader::append_text(const std::string& text, const std::string& name, const fs::path& file,
                             Body& body, std::vector<PlacedDirective>& found) {
  const int index = file_index(name);
  std::size_t copied = 0;
  int line = 1;
  for (const Directive& directive : parse_directives(text, name)) {
    const std::string_view before = std::string_view(text).substr(copied, directive.begin - copied);
    body.append(before, index, line);
    line = directive.line;
    const std::string_view taken =
        std::string_view(text).substr(directive.begin, directive.end - directive.begin);
    if (directive.kind == Directive::Kind::include) {
      body.break_line();
      include(directive, name, file, body, found);
    } else if (directive.kind == Directive::Kind::version) {
      project_.versions.push_back({index, directive.line});
    } else {
      found.push_back({directive, file});
    }
    // A directive of several lines leaves as many behind, so that the next ones keep their numbers.
    const auto newlines = static_cast<int>(std::count(taken.begin(), taken.end(), '\n'));
    body.append(std::string(static_cast<std::size_t>(newlines), '\n'), index, line);
    line += newlines;
    copied = directive.end;
  }
  body.append(std::string_view(text).substr(copied), index, line);
  body.break_line();
}

void TextLoader::include(const Directive& directive, const std::string& name, const fs::path& file,
                         Body& body, std::vector<PlacedDirective>& found) {
  const std::string at = name + ":" + std::to_string(directive.line) + ": error: ";
  const std::vector<fs::path> places = candidates(directive.text, file, root_);
  const std::optional<fs::path> target = find_file(places);
  if (!target)
    throw Error(ExitStatus::file,
                at + "can't find \"" + directive.text + "\" to include; tried " + names(places));
  const fs::path real = identity(*target);
  if (skipped_.contains(real)) return;
  const auto again = std::find(open_.begin(), open_.end(), real);
  if (again != open_.end()) {
    std::string chain;
    for (auto step = again; step != open_.end(); ++step) chain += display_name(*step) + " -> ";
    throw Error(ExitStatus::shader, at + "the include goes in a circle: " + chain + display_name(real));
  }
  if (fs::is_directory(real)) throw Error(ExitStatus::file, at + display_name(*target) + " is a folder");
  if (body.size() > max_body || ++includes_ > max_includes)
    throw Error(ExitStatus::shader, at + "the includes add up to too much");
  append(*target, body, found);
}

std::string to_text(const Defines& defines) {
  std::string text;
  for (const auto& [name, value] : defines) {
    const std::vector<Token> tokens = tokenize(name);
    if (tokens.size() != 1 || tokens[0].kind != Token::Kind::identifier || tokens[0].text != name)
      throw Error(ExitStatus::usage,
                  "-D " + name + ": the name is a letter or _ and then letters, digits and _");
    if (value.find_first_of("\r\n") != std::string::npos)
      throw Error(ExitStatus::usage, "-D " + name + ": the value is one line");
    text += "#define " + name + " " + value + "\n";
  }
  return text;
}

}  // namespace shadertwin

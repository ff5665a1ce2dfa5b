// Turns the text files of a pass into its body: includes expanded, directives taken out, lines kept apart.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "host/base/error.h"
#include "host/project/body.h"
#include "host/project/directives.h"
#include "host/project/project.h"

namespace shadertwin {

// A directive that is not an include, with the file it stands in.
struct PlacedDirective {
  Directive directive;
  std::filesystem::path file;
};

class TextLoader {
 public:
  // Adds the names of the files it reads to project.files.
  TextLoader(Project& project, std::filesystem::path root) : project_(project), root_(std::move(root)) {}

  // A file that is in every body already: an #include of it stands for nothing.
  void skip(const std::filesystem::path& file);

  // Appends `file` with its includes to `body`, and its directives to `found`. Throws as load_project does.
  void append(const std::filesystem::path& file, Body& body, std::vector<PlacedDirective>& found);

  // Appends a text that is not in a file of its own: `name` stands in messages, `file` is what paths are
  // relative to.
  void append_text(const std::string& text, const std::string& name, const std::filesystem::path& file,
                   Body& body, std::vector<PlacedDirective>& found);

 private:
  int file_index(const std::string& name);
  void include(const Directive& directive, const std::string& name, const std::filesystem::path& file,
               Body& body, std::vector<PlacedDirective>& found);

  Project& project_;
  std::filesystem::path root_;
  std::vector<std::filesystem::path> open_;  // the files that are being included, outermost first
  std::set<std::filesystem::path> skipped_;
  int includes_ = 0;
};

// `#define NAME VALUE`, a line each. Throws Error(usage) for a name that GLSL does not allow.
std::string to_text(const Defines& defines);

// Error(status) about a directive: `file:line: error: message`.
[[noreturn]] void fail_at(ExitStatus status, const std::filesystem::path& file, int line,
                          const std::string& message);

}  // namespace shadertwin

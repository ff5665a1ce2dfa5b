#include "host/project/project.h"

#include "host/base/error.h"
#include "host/project/load.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace {

Project read_any(const std::filesystem::path& shader, const LoadOptions& options) {
  std::error_code problem;
  if (shader.empty()) throw Error(ExitStatus::usage, "no shader is given");
  if (std::filesystem::is_directory(shader, problem)) return read_folder(shader, options);
  if (plain_name(shader.extension().string()) == ".json") return read_json(shader, options);
  return read_file(shader, options);
}

}  // namespace

Project read_project(const std::filesystem::path& shader, const LoadOptions& options) {
  Project project = read_any(shader, options);
  static_cast<PlaySettings&>(project) = options.settings;
  project.vscode_quirks = project.vscode_quirks && project.dialect == Dialect::vscode;
  return project;
}

int find_pass(const Project& project, const std::string& name) {
  for (std::size_t i = 0; i < project.passes.size(); ++i)
    if (project.passes[i].name == name) return static_cast<int>(i);
  for (std::size_t i = 0; i < project.passes.size(); ++i)
    if (plain_name(project.passes[i].name) == plain_name(name)) return static_cast<int>(i);
  return -1;
}

int need_pass(const Project& project, const std::string& name) {
  if (const int pass = find_pass(project, name); pass >= 0) return pass;
  std::string names;
  for (const Pass& pass : project.passes) names += (names.empty() ? "" : ", ") + pass.name;
  throw Error(ExitStatus::usage, "--pass " + name + ": the passes are " + names);
}

int find_sound(const Project& project) {
  for (std::size_t i = 0; i < project.passes.size(); ++i)
    if (project.passes[i].kind == PassKind::sound) return static_cast<int>(i);
  return -1;
}

}  // namespace shadertwin

#include <fstream>
#include <memory>

#include "host/app/command.h"
#include "host/app/options.h"
#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/export/export.h"
#include "host/export/output_folder.h"
#include "host/project/write_json.h"
#include "reference/emit/emit_cpp.h"

namespace shadertwin::app {

namespace {

enum class Form { html, tabs, json, cpp };

struct ExportOptions : PlayOptions {
  Form to = Form::html;
  std::string output;
};

// The shader's name. image.glsl says less than the folder that it stands in.
std::string title_of(const std::filesystem::path& shader) {
  const std::filesystem::path whole =
      (std::filesystem::absolute(shader) / "").lexically_normal().parent_path();
  return (whole.stem() == "image" ? whole.parent_path() : whole).stem().string();
}

Project titled(Project project, const std::filesystem::path& shader) {
  if (project.title.empty()) project.title = title_of(shader);
  return project;
}

// A C++ file a pass: what the CPU twin compiles.
void write_cpp(const Project& project, const std::filesystem::path& folder) {
  // reference/ holds the headers that it includes.
  const std::string how =
      "// c++ -std=c++20 -O2 -ffp-contract=off -fPIC -shared -I SOURCES-OF-SHADERTWIN THIS-FILE -o pass.so\n";
  OutputFolder output(folder);
  for (const Pass& pass : project.passes) {
    if (pass.vertex.has_value())
      throw Error(ExitStatus::shader,
                  pass.name + ": error: the twin draws no triangles of a vertex shader (#iVertex)");
    output.write(file_stem(pass.name) + ".cpp", how + emit_cpp(project, pass));
  }
  output.commit();
}

void export_project(const ExportOptions& options) {
  const Project project = load(options);
  switch (options.to) {
    case Form::html:
      return write_file(options.output, html_player(project, title_of(options.shader)));
    case Form::tabs:
      return write_tabs(for_site(project), options.output);
    case Form::json:
      return write_file(options.output, write_json(titled(for_site(project), options.shader)));
    case Form::cpp:
      return write_cpp(project, options.output);
  }
}

// What plays the export has its own sound, and its own entry points where it gets the user's text.
void refuse_without_effect(const ExportOptions& options) {
  if (options.to == Form::cpp) refuse(options, NoEffect::on_cpp_export, "has no effect on --to cpp");
  if (options.to == Form::tabs || options.to == Form::json)
    refuse(options, NoEffect::on_site_export,
           "has no effect on what shadertoy.com takes (--to tabs, --to json)");
}

}  // namespace

void add_export(CommandLine app) {
  const CommandLine command = app.add_subcommand("export", "write a shader in a form to pass on");
  const auto options = std::make_shared<ExportOptions>();
  add_options(command, Command::export_, *options);
  add_choice<Form, Form>(
      command, "--to", options->to,
      {{"html", Form::html}, {"tabs", Form::tabs}, {"json", Form::json}, {"cpp", Form::cpp}},
      "html: a page that plays it in any browser, with everything inside (#paused, #time=SECONDS, "
      "#size=WxH or #bare behind its address set it up); tabs: a folder with a text a tab to paste "
      "into shadertoy.com, and BINDINGS.txt; json: as Shadertoy's API gives a shader; cpp: a folder with "
      "a C++ file a pass, "
      "as the CPU twin compiles it")
      .required();
  command.add_option("-o,--output", options->output, "the file to write; for tabs and cpp a new folder")
      .required();
  command.callback([options] {
    refuse_without_effect(*options);
    export_project(*options);
  });
}

}  // namespace shadertwin::app

// shadertwin-emit: functions of a shader as a C++ header, at build time. What shadertwin_add_twin() runs.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>

#include "host/base/error.h"
#include "host/base/output_file.h"
#include "host/project/body.h"
#include "host/project/text_file.h"
#include "host/project/text_loader.h"
#include "host/text/resolve_macros.h"
#include "reference/emit/emit_cpp.h"

namespace {

using namespace shadertwin;

// What a shader may rely on without declaring it.
constexpr const char* head =
    "uniform vec3 iResolution; uniform float iTime, iTimeDelta, iFrameRate; uniform int iFrame; uniform vec4 "
    "iDate, iMouse;\n"
    "uniform float iSampleRate, iChannelTime[4]; uniform vec3 iChannelResolution[4];\n"
    "uniform sampler2D iChannel0, iChannel1, iChannel2, iChannel3;\n";

struct Arguments {
  std::vector<std::string> files;
  std::vector<std::string> defines;
  std::string name;
  std::string output;
  bool double_precision = false;
};

Project read(const Arguments& arguments) {
  Project project;
  for (const std::string& define : arguments.defines) {
    const std::size_t equals = define.find('=');
    project.defines.emplace_back(define.substr(0, equals),
                                 equals == std::string::npos ? "" : define.substr(equals + 1));
  }
  Body body;
  body.append(to_text(project.defines), -1, 0);
  for (const std::string& file : arguments.files) {
    body.append(read_text(file), static_cast<int>(project.files.size()), 1);
    body.break_line();
    project.files.push_back(file);
  }
  Pass pass;
  pass.source.head = head;
  pass.source.own_output = true;
  pass.source.body = body.text();
  pass.source.lines = body.lines();
  resolve_macros(project, pass.source, ShaderStage::fragment);
  project.passes.push_back(pass);
  return project;
}

void run(const Arguments& arguments) {
  const Project project = read(arguments);
  CppOptions options;
  options.double_precision = arguments.double_precision;
  const std::string text = emit_header(project, project.passes.front(), arguments.name, options);
  OutputFile output(arguments.output);
  std::ofstream(output.path(), std::ios::binary) << text;
  output.commit();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes the functions of a shader as a C++ header."};
  Arguments arguments;
  app.add_option("files", arguments.files, "GLSL files, read one behind the other")->required();
  app.add_option("-D,--define", arguments.defines, "NAME or NAME=VALUE, as #define in front of the files");
  app.add_option("--namespace", arguments.name, "the namespace of the functions")->required();
  app.add_option("-o,--output", arguments.output, "the header to write")->required();
  app.add_flag("--double", arguments.double_precision, "for a target with SHADERTWIN_DOUBLE");
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.status());
  }
  return 0;
}

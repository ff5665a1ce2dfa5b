#include "host/text/load.h"

#include "host/text/canonicalise.h"
#include "host/text/host_text.h"
#include "host/text/resolve_macros.h"

namespace shadertwin {

Project load_project(const std::filesystem::path& shader, const LoadOptions& options) {
  Project project = read_project(shader, options);
  const auto prepare = [&](PassSource& source, Stage stage) {
    resolve_macros(project, source, stage);
    source.body = canonicalise(source.body);
  };
  for (Pass& pass : project.passes) {
    prepare(pass.source, Stage::fragment);
    if (pass.vertex.has_value()) prepare(*pass.vertex, Stage::vertex);
    write_host_text(project, pass, options.vr);
  }
  return project;
}

}  // namespace shadertwin

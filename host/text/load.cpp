#include "host/text/load.h"

#include "host/text/canonicalise.h"
#include "host/text/host_text.h"
#include "host/text/other_uniforms.h"
#include "host/text/resolve_macros.h"
#include "host/text/uniform_blocks.h"

namespace shadertwin {

Project load_project(const std::filesystem::path& shader, const LoadOptions& options) {
  Project project = read_project(shader, options);
  const auto canonicalise_body = [&](PassSource& source) { source.body = canonicalise(source.body); };
  for (std::size_t i = 0; i < project.passes.size(); ++i) {
    Pass& pass = project.passes[i];
    resolve_macros(project, pass.source, Stage::fragment);
    canonicalise_body(pass.source);
    adopt_other_uniforms(project, i, pass);
    empty_uniform_blocks(pass);
    if (pass.vertex.has_value()) {
      resolve_macros(project, *pass.vertex, Stage::vertex);
      canonicalise_body(*pass.vertex);
    }
    write_host_text(project, pass, options.vr);
  }
  return project;
}

}  // namespace shadertwin

#include "host/text/load.h"

#include "host/text/canonicalise.h"
#include "host/text/global_initialisers.h"
#include "host/text/host_text.h"
#include "host/text/knobs.h"
#include "host/text/other_uniforms.h"
#include "host/text/resolve_macros.h"
#include "host/text/uniform_blocks.h"

namespace shadertwin {

namespace {

// A slip in a -D would change nothing, and nobody would know.
void warn_of_defines(Project& project) {
  for (const std::string& name : unmentioned_defines(project)) {
    const std::string nearest = nearest_knob(project, name);
    project.warnings.push_back("-D " + name + ": warning: no pass mentions " + name +
                               (nearest.empty() ? "" : "; is " + nearest + " meant?"));
  }
}

}  // namespace

Project load_project(const std::filesystem::path& shader, const LoadOptions& options) {
  Project project = read_project(shader, options);
  project.uniforms.insert(project.uniforms.end(), options.uniforms.begin(), options.uniforms.end());
  const auto canonicalise_body = [&](PassSource& source) {
    source.body = canonicalise(source.body, source.es100);
  };
  for (std::size_t i = 0; i < project.passes.size(); ++i) {
    Pass& pass = project.passes[i];
    resolve_macros(project, pass.source, ShaderStage::fragment);
    canonicalise_body(pass.source);
    if (pass.source.es100) pass.source.body = assign_globals_in_main(pass.source.body);
    adopt_other_uniforms(project, i, pass);
    if (pass.vertex.has_value()) {
      resolve_macros(project, *pass.vertex, ShaderStage::vertex);
      canonicalise_body(*pass.vertex);
    }
    empty_uniform_blocks(pass);
    write_host_text(project, pass);
  }
  warn_of_defines(project);
  return project;
}

}  // namespace shadertwin

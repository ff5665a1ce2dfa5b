#include "host/text/load.h"

#include "host/text/host_text.h"

namespace shadertwin {

Project load_project(const std::filesystem::path& shader, const LoadOptions& options) {
  Project project = read_project(shader, options);
  for (Pass& pass : project.passes) write_host_text(project, pass, options.vr);
  return project;
}

}  // namespace shadertwin

// What the host puts around the user's text, whatever the device: uniforms and main().
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

// Fills the head and tail of pass.source around its body and has_vr, and makes the body one that every
// compiler takes (canonicalise.h); everything else of project and pass is final by then. Throws Error(shader)
// if the body has no entry point.
void write_host_text(const Project& project, Pass& pass);

// Lines `uniform TYPE NAME;` of everything that players set by either host's names, as the pass would have
// it.
std::string host_uniforms(const Project& project, const Pass& pass);

}  // namespace shadertwin

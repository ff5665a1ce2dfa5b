// The preprocessor as a stage: behind it, nothing is left of directives and macros but #extension and
// #pragma.
#pragma once

#include "host/project/project.h"
#include "host/text/shader_stage.h"

namespace shadertwin {

// Resolves the directives and macros of source.body by browsers' rules, with the macros that stand in front
// of it on the project's host. Lines stay where they are. source.written is then what the body was, and
// source.refused says what a browser does not take.
void resolve_macros(const Project& project, PassSource& source, ShaderStage stage);

// Throws Error(shader) if source.refused says anything.
void throw_if_refused(const PassSource& source);

}  // namespace shadertwin

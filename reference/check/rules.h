// What can be said of a shader without running it.
#pragma once

#include <vector>

#include "host/project/project.h"
#include "reference/check/finding.h"

namespace shadertwin::check {

struct ParsedPass;  // parsed_pass.h

// What compiling a pass tells, kind `webgl2`: with any of these the shader can't be run.
std::vector<Finding> compile_errors(const Project& project, const Pass& pass);

// Errors of the Common tab where shadertoy.com compiles it by itself: functions there see no uniforms but
// iDate and iSampleRate. Not those at places in `known`. None for the extension, which has no such tab.
std::vector<Finding> common_errors(const Project& project, const std::vector<Finding>& known);

// What browsers refuse although native compilers take it (kind `webgl2`), and what only one of shadertoy.com
// and the VS Code extension knows or refuses (kind `portability`, but `webgl2` for what the project's own
// host refuses). Text inside #ifdef SHADER_TOY is for local hosts, so the site's rules don't hold there.
std::vector<Finding> text_rules(const Project& project);

// Loops without an end, a break, a return or a discard, which browsers refuse, kind `webgl2`; and those whose
// condition stays what it is in every round, kind `loop`.
std::vector<Finding> endless_loops(const ParsedPass& parsed);

// Variables that are larger than browsers allow, inputs that no vertex shader gives, and `?:`, commas and
// labels between types that browsers don't take there, kind `webgl2`. A local variable that nothing uses is
// not seen.
std::vector<Finding> browser_limits(const ParsedPass& parsed);

// Expressions that read a variable and change it, in operands or arguments that compilers evaluate in
// different orders, and calls that some drop, kind `portability`.
std::vector<Finding> evaluation_order(const ParsedPass& parsed);

// Macros that preprocessors other than browsers' expand differently, kind `portability`: those that name
// themselves where they are another one's argument, those that open an invocation which the text behind them
// closes, and directives between arguments.
std::vector<Finding> macro_rules(const Project& project);

// `out` parameters that some path through their function leaves unwritten, kind `out`. A loop counts as if
// its body ran.
std::vector<Finding> unwritten_outputs(const ParsedPass& parsed);

// What all of these find, sorted.
struct Reading {
  std::vector<Finding> findings;
  bool can_run = true;  // it compiles, and its loops end
};
Reading read_rules(const Project& project);

}  // namespace shadertwin::check

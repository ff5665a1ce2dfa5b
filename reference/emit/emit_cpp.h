// A pass as readable C++: one function for one function of the shader, under the same names.
#pragma once

#include <string>

#include "host/project/project.h"

namespace shadertwin {

struct CppOptions {
  bool double_precision = false;   // constants are folded and written as double
  bool loop_guards = false;        // every loop asks whether it has to stop
  bool checks = false;             // tells twin::Checks of its places, values and rounds
  bool shadows = false;            // tells twin::Shadows of its places; for -DSHADERTWIN_SHADOW
  bool packets = false;            // eight pixels run side by side, against twin/packet_invocation.h
  bool initialise_locals = false;  // variables start at zero without the help of a compiler's flag
};

// The whole translation unit for a pass, to be compiled against reference/twin/invocation.h or, for
// packets, packet_invocation.h; for double_precision with -DSHADERTWIN_DOUBLE. #line directives name the
// user's own files. Throws Error(shader) with lines `file:line: error: text`.
std::string emit_cpp(const Project& project, const Pass& pass, const CppOptions& options = {});

// Changes with the emitter: what it made earlier may differ from what it would make now.
const char* emit_identity();

// The functions of a shader, with or without an entry point, as a header: free functions in the namespace
// `name`, to be included by tests. Global variables and uniforms become variables of the thread that a test
// may set. A function that is called alone has no neighbours: derivatives are zero and textures are read at
// their base level. Compile with the flags of shadertwin_glsl. Throws Error(shader).
std::string emit_header(const Project& project, const Pass& pass, const std::string& name,
                        const CppOptions& options = {});

}  // namespace shadertwin

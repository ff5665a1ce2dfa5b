// What the host puts around the user's text: version, precision, uniforms and main().
#pragma once

#include "host/project/project.h"

namespace shadertwin {

struct WrapOptions {
  bool keyboard = false;  // the extension's key names and functions
  bool strict = false;    // #StrictCompatibility: main() is the host's even if the user's text has one
  bool local = false;     // SHADER_TOY is defined: the text was written for a local host
  bool zero_outputs = true;
  bool vr = false;  // the picture is mainVR's
};

// Fills the head and tail of pass.source around its body and has_vr, and makes the body one that every
// compiler takes (browser_text.h); everything else of project and pass is final by then. Throws Error(shader)
// if the body has no entry point.
void wrap_pass(const Project& project, Pass& pass, const WrapOptions& options);

}  // namespace shadertwin

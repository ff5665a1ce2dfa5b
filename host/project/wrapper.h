// What the host puts around the user's text: version, precision, uniforms and main().
#pragma once

#include <array>
#include <utility>

#include "host/project/project.h"

namespace shadertwin {

// Names of GLSL ES 1.00, of its extensions and of older players, which the VS Code extension takes, and what
// they mean.
constexpr std::array<std::pair<const char*, const char*>, 11> legacy_names = {{
    {"texture2D", "texture"},
    {"textureCube", "texture"},
    {"texture2DProj", "textureProj"},
    {"texture2DLodEXT", "textureLod"},
    {"texture2DProjLodEXT", "textureProjLod"},
    {"textureCubeLodEXT", "textureLod"},
    {"texture2DGradEXT", "textureGrad"},
    {"texture2DProjGradEXT", "textureProjGrad"},
    {"textureCubeGradEXT", "textureGrad"},
    {"iGlobalTime", "iTime"},
    {"iGlobalFrame", "iFrame"},
}};

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

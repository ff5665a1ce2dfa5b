// What the host puts around the user's text, whatever the device: uniforms and main().
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

// Fills the head and tail of pass.source around its body and has_vr, and makes the body one that every
// compiler takes (canonicalise.h); everything else of project and pass is final by then. `vr`: the picture is
// mainVR's. Throws Error(shader) if the body has no entry point.
void write_host_text(const Project& project, Pass& pass, bool vr);

}  // namespace shadertwin

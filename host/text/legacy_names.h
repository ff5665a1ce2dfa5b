// Names that GLSL ES 3.00 has no more.
#pragma once

#include <array>
#include <utility>

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

}  // namespace shadertwin

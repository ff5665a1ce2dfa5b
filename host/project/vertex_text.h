// #iVertex: the text of a pass's own vertex shader.
#pragma once

#include <filesystem>
#include <optional>

#include "host/project/project.h"
#include "host/project/text_loader.h"

namespace shadertwin {

// The file that the last #iVertex of a pass names; nothing if there is none or it says "default". Earlier
// ones are a warning. Throws Error(shader) for what the extension refuses: "self", a URL, a file that is not
// .glsl.
std::optional<PlacedDirective> find_vertex(Project& project, const std::vector<PlacedDirective>& directives);

// Body and lines of that file, with its includes and the knobs. Of its directives only #include counts; the
// others are a warning. `root`: the file or folder that the user named. Throws as load_project does.
PassSource load_vertex(Project& project, TextLoader& texts, const PlacedDirective& at,
                       const std::filesystem::path& root, const LoadOptions& options);

}  // namespace shadertwin

// The one way to load a shader: every command and every reload goes through here.
#pragma once

#include <filesystem>

#include "host/project/project.h"

namespace shadertwin {

// read_project(), with every pass's text put into the host's, and a warning for each macro of the command
// line that no text mentions. Throws as it does, and Error(shader) for a pass without an entry point.
Project load_project(const std::filesystem::path& shader, const LoadOptions& options = {});

}  // namespace shadertwin

// The ways into a Project, one for each shape that a shader comes in.
#pragma once

#include <filesystem>

#include "host/project/project.h"

namespace shadertwin {

// A single file with the extension's directives: the passes it names are found through its channels.
Project read_file(const std::filesystem::path& file, const LoadOptions& options);

// A shader as Shadertoy hands it out.
Project read_json(const std::filesystem::path& file, const LoadOptions& options);

// A folder with a file for each tab.
Project read_folder(const std::filesystem::path& folder, const LoadOptions& options);

}  // namespace shadertwin

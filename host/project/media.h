// Files that a document from elsewhere names: only those inside of a folder that the user chose.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace shadertwin {

// The file `path` below `folder`. Nothing if it is not there. `refused` says why a path may not be opened at
// all: a URL, an absolute path, one that climbs out by "..", or a link that leads out.
std::optional<std::filesystem::path> file_inside(const std::filesystem::path& folder, const std::string& path,
                                                 std::string& refused);

}  // namespace shadertwin

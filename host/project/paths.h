// What a path in a directive means.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/project/project.h"

namespace shadertwin {

// What a channel with the path would be, by the extension: InputKind::none if a channel can't show it, and
// InputKind::pass for the text of a shader, which everything unknown is.
InputKind kind_of_file(const std::string& path);

// Whether the path is a URL that names another machine.
bool is_remote(const std::string& path);

// Every place that `path` may stand for, the likeliest first: beside `beside` (the file that holds the
// directive), as given, beside `root`. "file://" is dropped, backslashes are slashes.
std::vector<std::filesystem::path> candidates(const std::string& path, const std::filesystem::path& beside,
                                              const std::filesystem::path& root);

// The first candidate that is there; nothing if none is.
std::optional<std::filesystem::path> find_file(const std::vector<std::filesystem::path>& places);

// The names that a cubemap's faces go by, +X -X +Y -Y +Z -Z, the first set preferred.
std::span<const std::array<std::string_view, 6>> face_names();

// The six faces, +X -X +Y -Y +Z -Z, of a path with one {} or * in it. `missing` names the file that keeps the
// best set of names from being complete; the result is empty then.
std::vector<std::filesystem::path> find_faces(const std::vector<std::filesystem::path>& patterns,
                                              std::string& missing);

// Whether the path holds a placeholder for a face.
bool has_wildcard(const std::string& path);

}  // namespace shadertwin

// Text files as shaders are kept in them, and their names in messages.
#pragma once

#include <filesystem>
#include <string>

namespace shadertwin {

// The whole file, with "\n" for every line end and without a byte order mark. Throws Error(file) if it can't
// be read, is not text, or is over 64 MiB.
std::string read_text(const std::filesystem::path& file);

// `raw` with "\n" for every line end and without a byte order mark.
std::string unix_text(const std::string& raw);

// `file` as a user would name it: relative to the working folder if it lies below it, else absolute.
std::string display_name(const std::filesystem::path& file);

// One spelling for every path to the same file.
std::filesystem::path identity(const std::filesystem::path& file);

// `name` in lower case without spaces, underscores and hyphens: how names are compared that people type.
std::string plain_name(const std::string& name);

}  // namespace shadertwin

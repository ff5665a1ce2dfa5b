#include "host/project/media.h"

#include <algorithm>

#include "host/project/paths.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

std::optional<fs::path> file_inside(const fs::path& folder, const std::string& path, std::string& refused) {
  std::string plain = path;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  const fs::path relative(plain);
  const bool drive = plain.size() > 1 && plain[1] == ':';
  if (plain.find("://") != std::string::npos)
    refused = "is a URL, and nothing is fetched";
  else if (relative.is_absolute() || drive || plain.find('\0') != std::string::npos)
    refused = "is an absolute path";
  else if (std::find(relative.begin(), relative.end(), "..") != relative.end())
    refused = "climbs out of its folder";
  if (!refused.empty()) return std::nullopt;
  const fs::path file = folder / relative;
  std::error_code problem;
  if (!fs::exists(file, problem)) return std::nullopt;
  const fs::path inside = identity(file).lexically_relative(identity(folder));
  if (inside.empty() || *inside.begin() == "..") {
    refused = "is a link that leads out of its folder";
    return std::nullopt;
  }
  return file;
}

}  // namespace shadertwin

#include "host/project/paths.h"

#include <algorithm>
#include <array>

#include "host/project/kinds.h"
#include "host/project/text_file.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

// The pattern's text before and after its placeholder.
bool split(const std::string& pattern, std::string& before, std::string& after) {
  std::size_t length = 2;
  std::size_t place = pattern.find("{}");
  if (place == std::string::npos) {
    length = 1;
    place = pattern.find('*');
  }
  if (place == std::string::npos) return false;
  before = pattern.substr(0, place);
  after = pattern.substr(place + length);
  return true;
}

}  // namespace

InputKind kind_of_file(const std::string& path) {
  std::string extension = plain_name(fs::path(path).extension().string()) + ' ';
  for (const InputKindInfo& kind : input_kinds)
    if (extension != " " && kind.extensions.find(extension) != std::string_view::npos) return kind.kind;
  const bool unsupported =
      extension == ".json " || extension == ".pdf " || extension == ".zip " || extension == ".html ";
  return unsupported ? InputKind::none : InputKind::pass;
}

bool is_remote(const std::string& path) {
  const std::size_t colon = path.find("://");
  return colon != std::string::npos && colon > 0 && path.substr(0, colon) != "file";
}

std::vector<fs::path> candidates(const std::string& path, const fs::path& beside, const fs::path& root) {
  std::string plain = path.starts_with("file://") ? path.substr(7) : path;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  // "file:///faces.png" is written for <folder>/faces.png as often as for the root of the disk.
  const std::string below = plain.substr(std::min(plain.find_first_not_of('/'), plain.size()));
  std::vector<fs::path> places;
  if (plain != below) places.emplace_back(plain);
  places.push_back(beside.parent_path() / below);
  if (plain == below) places.emplace_back(plain);
  places.push_back(root.parent_path() / below);
  std::vector<fs::path> distinct;
  for (const fs::path& place : places) {
    const fs::path whole = fs::absolute(place).lexically_normal();
    if (std::find(distinct.begin(), distinct.end(), whole) == distinct.end()) distinct.push_back(whole);
  }
  return distinct;
}

std::optional<fs::path> find_file(const std::vector<fs::path>& places) {
  std::error_code problem;
  for (const fs::path& place : places)
    if (fs::exists(place, problem)) return place;
  return std::nullopt;
}

std::span<const std::array<std::string_view, 6>> face_names() {
  static constexpr std::array<std::array<std::string_view, 6>, 4> sets = {{
      {"e", "w", "u", "d", "n", "s"},
      {"east", "west", "up", "down", "north", "south"},
      {"px", "nx", "py", "ny", "pz", "nz"},
      {"posx", "negx", "posy", "negy", "posz", "negz"},
  }};
  return sets;
}

std::vector<fs::path> find_faces(const std::vector<fs::path>& patterns, std::string& missing) {
  std::size_t most = 0;
  for (const fs::path& pattern : patterns) {
    std::string before;
    std::string after;
    if (!split(pattern.generic_string(), before, after)) continue;
    for (const auto& set : face_names()) {
      std::vector<fs::path> faces;
      std::string first_missing;
      std::size_t there = 0;
      std::error_code problem;
      for (const std::string_view name : set) {
        faces.emplace_back(before + std::string(name) + after);
        if (fs::exists(faces.back(), problem))
          ++there;
        else if (first_missing.empty())
          first_missing = display_name(faces.back());
      }
      if (there == faces.size()) return faces;
      if (there > most || missing.empty()) {
        most = there;
        missing = first_missing;
      }
    }
  }
  return {};
}

bool has_wildcard(const std::string& path) {
  return path.find("{}") != std::string::npos || path.find('*') != std::string::npos;
}

}  // namespace shadertwin

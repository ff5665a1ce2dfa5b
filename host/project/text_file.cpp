#include "host/project/text_file.h"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "host/base/error.h"

namespace shadertwin {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t max_bytes = std::uintmax_t{64} << 20;

}  // namespace

std::string unix_text(const std::string& raw) {
  std::string text;
  text.reserve(raw.size());
  for (std::size_t i = raw.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < raw.size(); ++i) {
    if (raw[i] != '\r') {
      text += raw[i];
    } else {
      text += '\n';
      if (i + 1 < raw.size() && raw[i + 1] == '\n') ++i;
    }
  }
  return text;
}

std::string read_text(const fs::path& file) {
  const std::string name = display_name(file);
  std::error_code problem;
  const fs::file_status status = fs::status(file, problem);
  if (!fs::exists(status)) throw Error(ExitStatus::file, name + ": error: there is no such file");
  if (fs::is_directory(status)) throw Error(ExitStatus::file, name + ": error: is a folder, not a file");
  // A pipe has no size; everything else is measured before it is read.
  if (fs::is_regular_file(status) && fs::file_size(file, problem) > max_bytes)
    throw Error(ExitStatus::file, name + ": error: is too large for a text of a shader");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(ExitStatus::file, name + ": error: " + std::strerror(errno));
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) throw Error(ExitStatus::file, name + ": error: can't be read");
  std::string raw = std::move(content).str();
  if (raw.find('\0') != std::string::npos)
    throw Error(ExitStatus::file, name + ": error: is not a text file");
  return unix_text(raw);
}

std::string display_name(const fs::path& file) {
  std::error_code problem;
  const fs::path here = fs::current_path(problem);
  const fs::path absolute = (file.is_absolute() ? file : here / file).lexically_normal();
  const fs::path relative = absolute.lexically_relative(here);
  if (relative.empty() || *relative.begin() == "..") return absolute.generic_string();
  return relative.generic_string();
}

fs::path identity(const fs::path& file) {
  std::error_code problem;
  fs::path real = fs::weakly_canonical(file, problem);
  return problem ? fs::absolute(file).lexically_normal() : real;
}

std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : name)
    if (c != ' ' && c != '_' && c != '-')
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

}  // namespace shadertwin

#include "host/export/output_folder.h"

#include <unistd.h>

#include <cctype>
#include <fstream>
#include <system_error>

#include "host/base/error.h"

namespace shadertwin {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& target) : target_(fs::absolute(target / "").parent_path()) {
  std::error_code problem;
  if (fs::exists(target_, problem) && !(fs::is_directory(target_, problem) && fs::is_empty(target_, problem)))
    throw Error(ExitStatus::file, target.string() + ": is there already");
  temporary_ = target_.parent_path() /
               ("." + target_.filename().string().substr(0, 200) + "." + std::to_string(getpid()));
  unfinished_.emplace_back(temporary_);
  fs::create_directory(temporary_, problem);
  if (problem) throw Error(ExitStatus::file, target.string() + ": " + problem.message());
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void OutputFolder::write(const std::string& name, const std::string& text) {
  unfinished_.emplace_back(temporary_ / name);
  std::ofstream stream(temporary_ / name, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw Error(ExitStatus::file, (target_ / name).string() + ": can't be written");
}

void OutputFolder::copy(const fs::path& file, const std::string& name) {
  unfinished_.emplace_back(temporary_ / name);
  std::error_code problem;
  fs::copy_file(file, temporary_ / name, problem);
  if (problem) throw Error(ExitStatus::file, file.string() + ": " + problem.message());
}

void OutputFolder::commit() {
  std::error_code problem;
  fs::rename(temporary_, target_, problem);
  if (problem) throw Error(ExitStatus::file, target_.string() + ": " + problem.message());
  temporary_.clear();
  unfinished_.clear();
}

std::string file_stem(std::string pass) {
  for (char& c : pass) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return pass;
}

}  // namespace shadertwin
